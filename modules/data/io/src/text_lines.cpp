// SPDX-License-Identifier: BSD-3-Clause
#include "text_lines.h"

#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {

TextLines::TextLines(const std::string& text, std::string where)
    : text_(text), where_(std::move(where)) {}

bool TextLines::next(std::string& line) {
  while (begin_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', begin_), text_.size());
    line = trim(text_.substr(begin_, end - begin_));
    begin_ = end + 1;
    ++number_;
    if (line.empty()) continue;
    if (line[0] != '#') return true;
    remark_ = line;
  }
  return false;
}

std::string TextLines::here() const {
  return where_ + ":" + std::to_string(number_);
}

Error TextLines::error(const std::string& what, const std::string& expected) const {
  return file_error(here(), what, expected);
}

std::vector<std::string> split_at_blanks(const std::string& line) {
  std::vector<std::string> parts;
  for (std::size_t begin = line.find_first_not_of(" \t"); begin != std::string::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    parts.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(" \t", end);
  }
  return parts;
}

std::vector<double> numbers_of(const std::vector<std::string>& fields, std::size_t count,
                               const TextLines& lines) {
  if (fields.size() != count)
    throw lines.error(count_text(fields.size(), "field"), std::to_string(count) + " numbers");
  std::vector<double> numbers(count);
  for (std::size_t i = 0; i < count; ++i)
    if (!parse_number(fields[i], numbers[i]))
      throw lines.error("invalid number in field " + std::to_string(i + 1), "a finite number");
  return numbers;
}

}  // namespace slalom
