#include "shared_memory.h"

#include <slalom/core/error.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <sys/mman.h>
#include <sys/stat.h>

namespace slalom {
namespace {

constexpr int kSeals = F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;

}  // namespace

FileDescriptor create_shared_memory() {
  return FileDescriptor(memfd_create("slalom tables", MFD_CLOEXEC | MFD_ALLOW_SEALING));
}

void append_to_shared_memory(int file, const void* data, std::size_t size) {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = write(file, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0)
      throw job_error("shared memory", std::string("cannot be written (") + strerror(errno) + ")");
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
}

bool seal_shared_memory(int file) {
  return fcntl(file, F_ADD_SEALS, kSeals) == 0;
}

SharedArray<std::byte> map_shared_memory(int file) {
  struct stat status = {};
  if (fcntl(file, F_GET_SEALS) != kSeals || fstat(file, &status) != 0 || status.st_size == 0)
    return {};
  const auto size = static_cast<std::size_t>(status.st_size);
  // Private: before Linux 6.7 sealed memory cannot be mapped as shared. All pages at once: a page
  // fault for each would take longer.
  void* memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file, 0);
  if (memory == MAP_FAILED) return {};
  const auto unmap = [size](const std::byte* data) { munmap(const_cast<std::byte*>(data), size); };
  return {std::shared_ptr<const std::byte>(static_cast<const std::byte*>(memory), unmap), size};
}

}  // namespace slalom
