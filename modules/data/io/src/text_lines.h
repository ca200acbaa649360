// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>

#include <string>
#include <vector>

namespace slalom {

/// Iterates over the lines of a text file that have content, with their numbers. Lines that begin
/// with '#' have none. The text must outlive it.
class TextLines {
 public:
  TextLines(const std::string& text, std::string where);

  bool next(std::string& line);  ///< trimmed; false at the end
  std::string here() const;      ///< WHERE:LINE of the last one
  std::size_t number() const { return number_; }
  /// The last line that began with '#', trimmed; "" if none did.
  const std::string& remark() const { return remark_; }
  Error error(const std::string& what, const std::string& expected) const;

 private:
  const std::string& text_;
  std::string where_, remark_;
  std::size_t begin_ = 0, number_ = 0;
};

std::vector<std::string> split_at_blanks(const std::string& line);

/// Throws Error (File) with the line unless there are `count` fields and all are finite numbers.
std::vector<double> numbers_of(const std::vector<std::string>& fields, std::size_t count,
                               const TextLines& lines);

}  // namespace slalom
