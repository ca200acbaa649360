// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/shared_array.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

namespace slalom {

/// Arrays one after another, aligned and in this machine's representation, for other processes of
/// the same program: they read them where they are (ArrayReader).
class ArrayWriter {
 public:
  using Sink = std::function<void(const void* data, std::size_t bytes)>;
  explicit ArrayWriter(Sink sink) : sink_(std::move(sink)) {}

  template <typename T>
  void write(const T* data, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>, "only bytes are written");
    write_bytes(data, count * sizeof(T));
  }
  template <typename T>
  void write(const SharedArray<T>& array) {
    write(array.data(), array.size());
  }

 private:
  void write_bytes(const void* data, std::size_t bytes);

  Sink sink_;
};

/// Arrays in memory that an ArrayWriter wrote, in the same order. They keep the memory, which must
/// be aligned like a cache line; nothing is copied.
class ArrayReader {
 public:
  explicit ArrayReader(SharedArray<std::byte> memory) : memory_(std::move(memory)) {}

  /// Throws Error (Job) unless the next array has `count` elements and lies in the memory.
  template <typename T>
  SharedArray<T> read(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>, "only bytes are read");
    const auto* data = reinterpret_cast<const T*>(take(count * sizeof(T)));
    return {std::shared_ptr<const T>(memory_.owner(), data), count};
  }
  /// Throws Error (Job) if more follows.
  void expect_end() const;

 private:
  const std::byte* take(std::size_t bytes);

  SharedArray<std::byte> memory_;
  std::size_t position_ = 0;
};

}  // namespace slalom
