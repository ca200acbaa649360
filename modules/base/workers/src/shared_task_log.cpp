// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/workers/shared_task_log.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <sys/mman.h>
#include <unistd.h>

namespace slalom {

/// At the beginning of the shared memory, followed by the log.
struct SharedTaskLog::Header {
  std::atomic<std::uint64_t> size, heartbeats, retired, disconnected;
  char* bytes() { return reinterpret_cast<char*>(this + 1); }
};

SharedTaskLog::SharedTaskLog(std::size_t capacity) : SharedTaskLog(capacity, -1) {}

SharedTaskLog::SharedTaskLog(std::size_t capacity, int file) : capacity_(capacity) {
  void* memory = mmap(nullptr, sizeof(Header) + capacity_, PROT_READ | PROT_WRITE,
                      MAP_SHARED | (file < 0 ? MAP_ANONYMOUS : 0), file, 0);
  if (memory == MAP_FAILED) throw job_error("workers", "cannot allocate shared memory");
  header_ = new (memory) Header();
  clear();
}

int SharedTaskLog::make_file(std::size_t capacity) {
  const int file = memfd_create("slalom log", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (file >= 0 && ftruncate(file, static_cast<off_t>(sizeof(Header) + capacity)) == 0 &&
      fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) == 0)
    return file;
  const int error = errno;
  if (file >= 0) close(file);
  errno = error;
  return -1;
}

SharedTaskLog::~SharedTaskLog() {
  munmap(header_, sizeof(Header) + capacity_);
}

void SharedTaskLog::clear() {
  header_->size = 0;
  header_->heartbeats = 0;
  header_->retired = 0;
  header_->disconnected = 0;
}

void SharedTaskLog::append(const void* data, std::size_t size) {
  const std::uint64_t used = header_->size;
  if (used > capacity_ || size > capacity_ - used) return;
  std::memcpy(header_->bytes() + used, data, size);
  header_->size = used + size;
}

std::string SharedTaskLog::contents() const {
  // A method that corrupts memory may have changed the size: clamp it to the capacity.
  const std::size_t size = std::min<std::uint64_t>(header_->size, capacity_);
  return {header_->bytes(), size};
}

void SharedTaskLog::heartbeat() {
  ++header_->heartbeats;
}

std::uint64_t SharedTaskLog::heartbeats() const {
  return header_->heartbeats;
}

void SharedTaskLog::retire_worker() {
  header_->retired = 1;
}

bool SharedTaskLog::is_retired() const {
  return header_->retired != 0;
}

void SharedTaskLog::report_disconnected() {
  header_->disconnected = 1;
}

bool SharedTaskLog::is_disconnected() const {
  return header_->disconnected != 0;
}

}  // namespace slalom
