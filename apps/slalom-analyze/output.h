#pragma once

#include <slalom/io/result_file.h>

#include <iostream>
#include <string>

namespace slalom {

/// Writes `text` to the file `output`, or to the standard output if that is empty or "-".
inline void print_or_write(const std::string& text, const std::string& output) {
  if (output.empty() || output == "-")
    std::cout << text;
  else
    write_file_atomically(output, text);
}

}  // namespace slalom
