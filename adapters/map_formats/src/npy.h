#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// A table of whole numbers, row by row.
struct NpyTable {
  std::size_t rows = 0, columns = 0;
  std::vector<std::int64_t> values;

  std::int64_t at(std::size_t row, std::size_t column) const {
    return values[row * columns + column];
  }
};

/// Reads a NumPy file (.npy, formats 1.0 and 2.0) that holds a two-dimensional array of 64-bit
/// integers, little-endian, in C order. Throws Error (File) with file, byte and reason for anything
/// else, for more than a million numbers, and where the file's length is not what its head says:
/// before memory is taken.
NpyTable read_npy(const std::string& path);
NpyTable parse_npy(const std::string& bytes, const std::string& path);

}  // namespace slalom
