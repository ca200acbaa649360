// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>

#include <string>
#include <vector>

namespace slalom {

/// A token of a selection expression.
struct SelectionToken {
  enum class Kind { Word, Number, Quoted, Symbol, End };
  Kind kind = Kind::End;
  std::string text;          ///< without quotes
  double number = 0;         ///< of a Number
  std::size_t position = 0;  ///< of its first character, from 1

  bool is_symbol(const char* symbol) const;
  bool is_keyword(const char* word) const;  ///< ignoring case
  std::string quoted_text() const;          ///< for messages: 'text', or "end of expression"
};

/// Splits a text into tokens; the last one is End. Throws Error (Usage) with the character
/// position.
std::vector<SelectionToken> tokenize_selection(const std::string& text);

/// "selection, character N: WHAT; expected EXPECTED"
Error selection_error(std::size_t position, const std::string& what, const std::string& expected);

}  // namespace slalom
