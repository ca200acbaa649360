// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"
#include "npy.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>

#include <cctype>

namespace slalom {
namespace {

constexpr std::uint64_t kMaxNumbers = 1'000'000;
constexpr std::size_t kNumberSize = 8;

/// Parses the header of a .npy file: a Python dictionary with three keys.
class NpyHeader {
 public:
  NpyHeader(const std::string& bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  NpyTable read() {
    find_end();
    expect('{');
    while (!accept('}')) {
      read_entry();
      accept(',');
    }
    if (!has_type_ || !has_order_ || !has_shape_)
      throw malformed("missing descr, fortran_order or shape");
    return table_;
  }

  std::size_t data_at() const { return end_; }

  Error malformed(const std::string& what) const {
    return file_error(path_, what + " at byte " + std::to_string(at_),
                      "a NumPy file (.npy) of rows of 64-bit integers");
  }

 private:
  /// Magic, version, length of the header (2 bytes in format 1, 4 in format 2).
  void find_end() {
    static const std::string kMagic = "\x93NUMPY";
    if (!starts_with(bytes_, kMagic)) throw malformed("does not start with NUMPY");
    at_ = kMagic.size();
    const unsigned version = byte();
    if (version != 1 && version != 2) throw malformed("unsupported version");
    byte();
    std::uint64_t size = 0;
    for (unsigned i = 0; i < (version == 1 ? 2U : 4U); ++i)
      size |= static_cast<std::uint64_t>(byte()) << (8 * i);
    if (size > bytes_.size() - at_) throw malformed("declares a header longer than the file");
    end_ = at_ + static_cast<std::size_t>(size);
  }

  unsigned byte() {
    if (at_ >= bytes_.size()) throw malformed("is truncated");
    return static_cast<unsigned char>(bytes_[at_++]);
  }

  void read_entry() {
    const std::string key = text();
    expect(':');
    if (key == "descr" && !has_type_) {
      has_type_ = text() == "<i8";
      if (!has_type_) throw malformed("unsupported number type, not '<i8',");
    } else if (key == "fortran_order" && !has_order_) {
      has_order_ = word() == "False";
      if (!has_order_) throw malformed("unsupported Fortran order");
    } else if (key == "shape" && !has_shape_) {
      read_shape();
    } else {
      throw malformed("unexpected key '" + key.substr(0, 20) + "'");
    }
  }

  void read_shape() {
    expect('(');
    table_.rows = number();
    expect(',');
    table_.columns = number();
    accept(',');
    expect(')');
    if (table_.rows == 0 || table_.columns == 0 || table_.rows > kMaxNumbers / table_.columns)
      throw malformed("declares " + std::to_string(table_.rows) + " x " +
                      std::to_string(table_.columns) + " numbers");
    has_shape_ = true;
  }

  void skip_blanks() {
    while (at_ < end_ && std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0) ++at_;
  }

  bool accept(char c) {
    skip_blanks();
    if (at_ >= end_ || bytes_[at_] != c) return false;
    ++at_;
    return true;
  }

  void expect(char c) {
    if (!accept(c)) throw malformed(std::string("missing '") + c + "' in the header");
  }

  std::string text() {
    expect('\'');
    const std::size_t close = bytes_.find('\'', at_);
    if (close == std::string::npos || close >= end_) throw malformed("unterminated text");
    const std::string found = bytes_.substr(at_, close - at_);
    at_ = close + 1;
    return found;
  }

  std::string word() {
    skip_blanks();
    std::string found;
    while (at_ < end_ && std::isalpha(static_cast<unsigned char>(bytes_[at_])) != 0)
      found += bytes_[at_++];
    return found;
  }

  std::size_t number() {
    skip_blanks();
    std::uint64_t value = 0;
    const std::size_t begin = at_;
    while (at_ < end_ && std::isdigit(static_cast<unsigned char>(bytes_[at_])) != 0) {
      value = 10 * value + static_cast<std::uint64_t>(bytes_[at_++] - '0');
      if (value > kMaxNumbers) throw malformed("declares too many numbers");
    }
    if (at_ == begin) throw malformed("is not two-dimensional");
    return static_cast<std::size_t>(value);
  }

  const std::string& bytes_;
  const std::string& path_;
  std::size_t at_ = 0, end_ = 0;
  bool has_type_ = false, has_order_ = false, has_shape_ = false;
  NpyTable table_;
};

std::int64_t number_at(const std::string& bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < kNumberSize; ++i)
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return static_cast<std::int64_t>(value);
}

}  // namespace

NpyTable parse_npy(const std::string& bytes, const std::string& path) {
  NpyHeader header(bytes, path);
  NpyTable table = header.read();
  const std::size_t count = table.rows * table.columns, begin = header.data_at();
  if (bytes.size() - begin != count * kNumberSize)
    throw file_error(path,
                     "contains " + std::to_string(bytes.size() - begin) +
                         " bytes of data after byte " + std::to_string(begin),
                     std::to_string(count * kNumberSize) + " for " + std::to_string(table.rows) +
                         " x " + std::to_string(table.columns) + " numbers");
  table.values.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    table.values.push_back(number_at(bytes, begin + i * kNumberSize));
  return table;
}

NpyTable read_npy(const std::string& path) {
  constexpr std::uint64_t kMaxFileSize = kMaxNumbers * kNumberSize + (1U << 17U);
  return parse_npy(read_file(path, "a NumPy array (.npy)", kMaxFileSize), path);
}

}  // namespace slalom
