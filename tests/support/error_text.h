// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace slalom {

/// Whether `text` contains each of `words`, in any order, ignoring case.
inline ::testing::AssertionResult mentions(const std::string& text,
                                           std::initializer_list<std::string> words) {
  for (const std::string& word : words)
    if (lower_case(text).find(lower_case(word)) == std::string::npos)
      return ::testing::AssertionFailure()
             << '"' << text << "\" does not mention \"" << word << '"';
  return ::testing::AssertionSuccess();
}

/// The text of the Error that `action` throws, marked in parentheses if there is no error, if its
/// kind is another one or if it has more than one line.
template <typename Action>
std::string error_text(ErrorKind kind, Action action) {
  try {
    action();
  } catch (const Error& error) {
    const std::string text = error.what();
    if (error.kind() != kind) return "(wrong kind) " + text;
    if (text.find('\n') != std::string::npos) return "(more than one line) " + text;
    return text;
  }
  return "(no error)";
}

/// Whether `action` throws an Error of `kind`, in one line that begins with `where` (file, section,
/// key, line) and mentions each of `words`.
template <typename Action>
::testing::AssertionResult throws_error(ErrorKind kind, const std::string& where,
                                        std::initializer_list<std::string> words, Action action) {
  const std::string text = error_text(kind, action);
  if (text.compare(0, where.size(), where) != 0)
    return ::testing::AssertionFailure()
           << '"' << text << "\" does not begin with \"" << where << '"';
  return mentions(text, words);
}

}  // namespace slalom
