#pragma once

#include <slalom/core/error.h>

#include <string>

namespace slalom {

/// The text of the Error that `action` throws; says so when it throws none, when another is to
/// blame, or when the text is not one line.
template <typename Action>
std::string error_text(Culprit culprit, Action action) {
  try {
    action();
  } catch (const Error& error) {
    const std::string text = error.what();
    if (error.culprit() != culprit) return "(wrong culprit) " + text;
    if (text.find('\n') != std::string::npos) return "(more than one line) " + text;
    return text;
  }
  return "(no error)";
}

}  // namespace slalom
