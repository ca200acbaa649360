// SPDX-License-Identifier: BSD-3-Clause
#include "shared_memory.h"

#include <slalom/core/error.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <random>
#include <sys/mman.h>
#include <sys/stat.h>
#include <utility>

namespace slalom {
namespace {

/// Not against growing: the writer enlarges the memory, and readers have the pages of their mapping
/// whatever its size.
constexpr int kSeals = F_SEAL_FUTURE_WRITE | F_SEAL_SHRINK | F_SEAL_SEAL;

/// At the begin of the memory, in a cache line of its own.
struct Header {
  std::uint64_t size;  ///< of the contents
  std::uint64_t id;    ///< of the memory, a random number
};
constexpr std::size_t kHeader = 64;
constexpr std::size_t kInitialCapacity = std::size_t{1} << 16;
/// Bytes of the mappings that a process keeps beyond the current one.
constexpr std::size_t kMaxKept = std::size_t{32} << 20;

/// Zero if there is none.
Header header_of(int file) {
  Header header = {};
  if (pread(file, &header, sizeof header, 0) != sizeof header) return {};
  return header;
}

Error failed(const std::string& what) {
  return job_error("shared memory", what + " (" + strerror(errno) + ")");
}

}  // namespace

FileDescriptor create_shared_memory() {
  return FileDescriptor(memfd_create("slalom tables", MFD_CLOEXEC | MFD_ALLOW_SEALING));
}

bool is_sealed(int file) {
  return fcntl(file, F_GET_SEALS) == kSeals;
}

SharedWriter::SharedWriter(int file) : capacity_(kInitialCapacity) {
  std::random_device random;
  id_ = std::uint64_t{random()} << 32U | random();
  if (ftruncate(file, static_cast<off_t>(capacity_)) != 0) throw failed("cannot be enlarged");
  void* memory = mmap(nullptr, capacity_, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (memory == MAP_FAILED) throw failed("cannot be mapped");
  memory_ = static_cast<std::byte*>(memory);
  finish();
  if (fcntl(file, F_ADD_SEALS, kSeals) == 0) return;
  munmap(memory_, capacity_);
  throw failed("cannot be sealed");
}

SharedWriter::~SharedWriter() {
  if (memory_ != nullptr) munmap(memory_, capacity_);
}

SharedWriter::SharedWriter(SharedWriter&& other) noexcept
    : id_(other.id_),
      memory_(std::exchange(other.memory_, nullptr)),
      capacity_(other.capacity_),
      size_(other.size_) {}

bool SharedWriter::writes(int file) const {
  return header_of(file).id == id_;
}

void SharedWriter::append(int file, const void* data, std::size_t size) {
  const std::size_t needed = kHeader + size_ + size;
  if (needed > capacity_) {
    const std::size_t larger = std::max(needed, 2 * capacity_);  // unused pages take no memory
    if (ftruncate(file, static_cast<off_t>(larger)) != 0) throw failed("cannot be enlarged");
    void* memory = mremap(memory_, capacity_, larger, MREMAP_MAYMOVE);
    if (memory == MAP_FAILED) throw failed("cannot be mapped");
    memory_ = static_cast<std::byte*>(memory);
    capacity_ = larger;
  }
  if (size > 0) std::memcpy(memory_ + kHeader + size_, data, size);
  size_ += size;
}

void SharedWriter::finish() {
  const Header header = {size_, id_};
  std::memcpy(memory_, &header, sizeof header);
}

SharedArray<std::byte> SharedReader::read(int file) {
  if (!is_sealed(file)) return {};
  const Header header = header_of(file);
  struct stat status = {};
  if (header.size == 0 || fstat(file, &status) != 0 ||
      header.size > static_cast<std::uint64_t>(status.st_size) - kHeader)
    return {};
  const SharedArray<std::byte> memory = map(file, header.id, kHeader + header.size);
  if (memory.size() == 0) return {};
  return {std::shared_ptr<const std::byte>(memory.owner(), memory.data() + kHeader), header.size};
}

/// At least the first `size` bytes.
SharedArray<std::byte> SharedReader::map(int file, std::uint64_t id, std::size_t size) {
  const auto known = std::find_if(mappings_.begin(), mappings_.end(),
                                  [&](const Mapping& one) { return one.id == id; });
  if (known != mappings_.end() && known->memory.size() >= size) {
    std::rotate(known, known + 1, mappings_.end());
    return mappings_.back().memory;
  }
  if (known != mappings_.end()) mappings_.erase(known);
  // All pages at once: a page fault for each would take longer.
  void* memory = mmap(nullptr, size, PROT_READ, MAP_SHARED | MAP_POPULATE, file, 0);
  if (memory == MAP_FAILED) return {};
  const auto unmap = [size](const std::byte* data) { munmap(const_cast<std::byte*>(data), size); };
  mappings_.push_back(
      {id, {std::shared_ptr<const std::byte>(static_cast<const std::byte*>(memory), unmap), size}});
  std::size_t kept = 0;
  for (std::size_t i = mappings_.size() - 1; i-- > 0;) {
    kept += mappings_[i].memory.size();
    if (kept > kMaxKept) mappings_.erase(mappings_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return mappings_.back().memory;
}

}  // namespace slalom
