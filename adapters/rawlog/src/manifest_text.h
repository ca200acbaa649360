#pragma once

#include <slalom/results/run_record.h>

#include <string>

namespace slalom {

/// A manifest as lines "key = value", sorted by key. A value of several lines (or with blanks at
/// its ends) follows its key, indented by two blanks.
std::string manifest_to_text(const Manifest& manifest);

/// Reads it back. Throws Error (File) naming `where` and the line.
Manifest manifest_from_text(const std::string& text, const std::string& where);

}  // namespace slalom
