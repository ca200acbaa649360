// SPDX-License-Identifier: BSD-3-Clause
#include "selection_lexer.h"

#include <slalom/core/text.h>

#include <cctype>

namespace slalom {
namespace {

using Kind = SelectionToken::Kind;

constexpr std::size_t kMaxLength = 32768;  ///< characters

bool begins_word(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || c == '_' || byte >= 0x80;
}

bool continues_word(char c) {
  return begins_word(c) || std::string("./:+-").find(c) != std::string::npos;
}

class Lexer {
 public:
  explicit Lexer(const std::string& text) : text_(text) {}

  std::vector<SelectionToken> tokens() {
    std::vector<SelectionToken> tokens;
    do {
      while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
      tokens.push_back(next());
    } while (tokens.back().kind != Kind::End);
    return tokens;
  }

 private:
  char peek(std::size_t ahead) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  SelectionToken next() {
    const char c = peek(0);
    if (at_ >= text_.size()) return {Kind::End, "", 0, text_.size() + 1};
    if (c == '\'' || c == '"') return quoted(c);
    const bool signed_number = (c == '-' || c == '+') && number_begins(1);
    if (begins_word(c) || signed_number || number_begins(0)) return word();
    return symbol();
  }

  bool number_begins(std::size_t ahead) const {
    const auto digit = [&](std::size_t i) {
      return std::isdigit(static_cast<unsigned char>(peek(i))) != 0;
    };
    return digit(ahead) || (peek(ahead) == '.' && digit(ahead + 1));
  }

  SelectionToken quoted(char quote) {
    SelectionToken token{Kind::Quoted, "", 0, at_ + 1};
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == quote && peek(1) != quote) {
        ++at_;
        return token;
      }
      if (text_[at_] == quote) ++at_;
      token.text += text_[at_];
    }
    throw selection_error(token.position, "unterminated quoted text", std::string(1, quote));
  }

  SelectionToken word() {
    const std::size_t begin = at_++;
    while (at_ < text_.size() && continues_word(text_[at_])) ++at_;
    SelectionToken token{Kind::Word, text_.substr(begin, at_ - begin), 0, begin + 1};
    if (number_like(token.text) && parse_number(token.text, token.number))
      token.kind = Kind::Number;
    return token;
  }

  static bool number_like(const std::string& text) {
    return text.find_first_of("0123456789") != std::string::npos &&
           std::isalpha(static_cast<unsigned char>(text[0])) == 0;
  }

  SelectionToken symbol() {
    SelectionToken token{Kind::Symbol, "", 0, at_ + 1};
    for (const char* known : {"<=", ">=", "==", "!=", "<>", "<", ">", "=", "(", ")", "[", "]", ","})
      if (text_.compare(at_, std::string(known).size(), known) == 0) {
        token.text = known;
        at_ += token.text.size();
        return token;
      }
    const bool printable = std::isprint(static_cast<unsigned char>(text_[at_])) != 0;
    throw selection_error(
        token.position,
        printable ? "unexpected '" + std::string(1, text_[at_]) + "'"
                  : std::string("unexpected unprintable character"),
        "a field, a number, a text in quotes, and, or, not, or one of < <= > >= = != ( ) [ ] ,");
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

bool SelectionToken::is_symbol(const char* symbol) const {
  return kind == Kind::Symbol && text == symbol;
}

bool SelectionToken::is_keyword(const char* word) const {
  return kind == Kind::Word && lower_case(text) == word;
}

std::string SelectionToken::quoted_text() const {
  if (kind == Kind::End) return "end of expression";
  std::string text_shown;
  for (const char c : text)
    text_shown += std::iscntrl(static_cast<unsigned char>(c)) != 0 ? '?' : c;
  return "'" + text_shown + "'";
}

std::vector<SelectionToken> tokenize_selection(const std::string& text) {
  if (text.size() > kMaxLength)
    throw selection_error(kMaxLength + 1, "expression is too long",
                          "at most " + std::to_string(kMaxLength) + " characters");
  return Lexer(text).tokens();
}

Error selection_error(std::size_t position, const std::string& what, const std::string& expected) {
  return usage_error("selection, character " + std::to_string(position), what, expected);
}

}  // namespace slalom
