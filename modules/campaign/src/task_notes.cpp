#include <slalom/campaign/task_notes.h>
#include <slalom/core/error.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>
#include <sys/mman.h>

namespace slalom {

/// Lies at the beginning of the shared memory, the notes behind it.
struct TaskNotes::Sheet {
  std::atomic<std::uint64_t> size, beats, retired;
  char* bytes() { return reinterpret_cast<char*>(this + 1); }
};

TaskNotes::TaskNotes(std::size_t capacity) : capacity_(capacity) {
  void* memory = mmap(nullptr, sizeof(Sheet) + capacity_, PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw job_error("workers", "no shared memory can be made");
  sheet_ = new (memory) Sheet();
  clear();
}

TaskNotes::~TaskNotes() {
  munmap(sheet_, sizeof(Sheet) + capacity_);
}

void TaskNotes::clear() {
  sheet_->size = 0;
  sheet_->beats = 0;
  sheet_->retired = 0;
}

void TaskNotes::append(const void* data, std::size_t size) {
  const std::uint64_t used = sheet_->size;
  if (used > capacity_ || size > capacity_ - used) return;
  std::memcpy(sheet_->bytes() + used, data, size);
  sheet_->size = used + size;
}

std::string TaskNotes::contents() const {
  // A method that writes wildly may have changed the size: never believe more than there is.
  const std::size_t size = std::min<std::uint64_t>(sheet_->size, capacity_);
  return {sheet_->bytes(), size};
}

void TaskNotes::beat() {
  ++sheet_->beats;
}

std::uint64_t TaskNotes::beats() const {
  return sheet_->beats;
}

void TaskNotes::retire_worker() {
  sheet_->retired = 1;
}

bool TaskNotes::is_retired() const {
  return sheet_->retired != 0;
}

}  // namespace slalom
