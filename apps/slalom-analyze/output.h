// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/result_file.h>

#include <functional>
#include <iostream>
#include <string>

namespace slalom {

/// Passes the file `output` to `write`, or the standard output if that is empty or "-".
inline void print_or_write(const std::function<void(std::ostream&)>& write,
                           const std::string& output) {
  if (output.empty() || output == "-")
    write(std::cout);
  else
    write_file_atomically(output, write);
}

inline void print_or_write(const std::string& text, const std::string& output) {
  print_or_write([&text](std::ostream& out) { out << text; }, output);
}

}  // namespace slalom
