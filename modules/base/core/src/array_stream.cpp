// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/array_stream.h>
#include <slalom/core/error.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

namespace slalom {
namespace {

/// A cache line. Each array begins at a multiple of it, after its size in a line of its own.
constexpr std::size_t kLine = 64;
using Line = std::array<std::byte, kLine>;

std::size_t padding_after(std::size_t bytes) {
  return (kLine - bytes % kLine) % kLine;
}

Error malformed(std::size_t position, const std::string& what, const std::string& expected) {
  return job_error("shared tables, byte " + std::to_string(position), what, expected);
}

}  // namespace

void ArrayWriter::write_bytes(const void* data, std::size_t bytes) {
  Line line = {};
  const std::uint64_t size = bytes;
  std::memcpy(line.data(), &size, sizeof size);
  sink_(line.data(), kLine);
  sink_(data, bytes);
  line = {};
  sink_(line.data(), padding_after(bytes));
}

const std::byte* ArrayReader::take(std::size_t bytes) {
  const std::size_t left = memory_.size() - position_;
  if (left < kLine) throw malformed(position_, "end of the memory", "another array");
  std::uint64_t size = 0;
  std::memcpy(&size, memory_.data() + position_, sizeof size);
  if (size != bytes || left - kLine < bytes || left - kLine - bytes < padding_after(bytes))
    throw malformed(
        position_,
        "an array of " + std::to_string(size) + " bytes in " + std::to_string(left - kLine),
        std::to_string(bytes) + " bytes");
  const std::byte* data = memory_.data() + position_ + kLine;
  position_ += kLine + bytes + padding_after(bytes);
  return data;
}

void ArrayReader::expect_end() const {
  if (position_ != memory_.size())
    throw malformed(position_, std::to_string(memory_.size() - position_) + " more bytes",
                    "the end of the memory");
}

}  // namespace slalom
