// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// A row-major table of integers.
struct NpyTable {
  std::size_t rows = 0, columns = 0;
  std::vector<std::int64_t> values;

  std::int64_t at(std::size_t row, std::size_t column) const {
    return values[row * columns + column];
  }
};

/// Reads a NumPy file (.npy, formats 1.0 and 2.0) with a two-dimensional array of 64-bit integers,
/// little-endian, in C order. Throws Error (File) with file, byte and reason, before memory is
/// allocated, for anything else, for more than a million numbers, and if the file's length does not
/// match its header.
NpyTable read_npy(const std::string& path);
NpyTable parse_npy(const std::string& bytes, const std::string& path);

}  // namespace slalom
