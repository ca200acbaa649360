// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// A file as written by NumPy: magic, version 1.0, length of the header, the header padded with
/// blanks to 128 bytes, the numbers.
inline std::string npy_with_header(std::string header, const std::vector<std::int64_t>& numbers) {
  header.resize(117, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size());
  bytes += '\0';
  bytes += header;
  for (const std::int64_t number : numbers)
    for (int i = 0; i < 8; ++i)
      bytes += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * i));
  return bytes;
}

inline std::string npy(std::size_t rows, std::size_t columns,
                       const std::vector<std::int64_t>& numbers) {
  return npy_with_header("{'descr': '<i8', 'fortran_order': False, 'shape': (" +
                             std::to_string(rows) + ", " + std::to_string(columns) + "), }",
                         numbers);
}

}  // namespace slalom
