#pragma once

#include <slalom/core/error.h>

#include <string>
#include <vector>

namespace slalom {

/// One piece of a selection expression.
struct SelectionToken {
  enum class Kind { Word, Number, Quoted, Symbol, End };
  Kind kind = Kind::End;
  std::string text;          ///< without quotes
  double number = 0;         ///< of a Number
  std::size_t position = 0;  ///< of its first character, from 1

  bool is_symbol(const char* symbol) const;
  bool is_key_word(const char* word) const;  ///< whatever the case
  std::string shown() const;                 ///< for messages: 'text', or "the end"
};

/// Cuts a text into tokens; the last one is End. Throws Error (Usage) naming the character.
std::vector<SelectionToken> cut_selection(const std::string& text);

/// "selection, character N: WHAT; expected EXPECTED"
Error selection_error(std::size_t position, const std::string& what, const std::string& expected);

}  // namespace slalom
