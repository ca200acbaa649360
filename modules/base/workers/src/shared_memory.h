// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "file_descriptor.h"

#include <slalom/core/shared_array.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace slalom {

/// Memory that processes share by its descriptor, to be given to one SharedWriter. None where the
/// system cannot.
FileDescriptor create_shared_memory();

/// Whether nobody can change the memory but its writer.
bool is_sealed(int file);

/// Writes contents into memory that other processes map: one after the other, since pages that
/// exist are written much faster than new ones. Nobody else can write it, in whatever process: it
/// is sealed as soon as it is mapped here (F_SEAL_FUTURE_WRITE, Linux 5.1).
class SharedWriter {
 public:
  /// `file`: new memory. Throws Error (Job) if it cannot be mapped and sealed.
  explicit SharedWriter(int file);
  ~SharedWriter();
  SharedWriter(SharedWriter&& other) noexcept;
  SharedWriter& operator=(SharedWriter&& other) = delete;

  bool writes(int file) const;  ///< whether it is a descriptor of this memory

  /// Starts new contents; no process may read the previous ones any more.
  void clear() { size_ = 0; }
  /// `file`: of this memory, to enlarge it. Throws Error (Job) if that is not possible.
  void append(int file, const void* data, std::size_t size);
  /// After the last append().
  void finish();

 private:
  std::uint64_t id_ = 0;
  std::byte* memory_ = nullptr;
  std::size_t capacity_ = 0, size_ = 0;
};

/// Maps memory for reading, and keeps mappings for the next contents of the same memory.
class SharedReader {
 public:
  /// The contents of sealed memory; empty if it is not sealed, cannot be mapped or is malformed. A
  /// process cannot make its mapping writable.
  SharedArray<std::byte> read(int file);

 private:
  struct Mapping {
    std::uint64_t id;
    SharedArray<std::byte> memory;
  };

  std::vector<Mapping> mappings_;  ///< the last used at the end

  SharedArray<std::byte> map(int file, std::uint64_t id, std::size_t size);
};

}  // namespace slalom
