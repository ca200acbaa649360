#include <slalom/core/error.h>
#include <slalom/core/temporary_file.h>
#include <slalom/io/result_file.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <unistd.h>

namespace slalom {
namespace {

/// On failure, returns false with errno set.
bool sync_file(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool synced = fsync(file) == 0;
  const int sync_errno = errno;
  close(file);
  errno = sync_errno;
  return synced;
}

}  // namespace

void write_file_atomically(const std::string& path,
                           const std::function<void(std::ostream&)>& write) {
  TemporaryFile temporary(path);
  const auto fail = [&](const char* what) {
    return job_error(path, std::string(what) + " (" + std::strerror(errno) + ")",
                     "a writable path");
  };
  std::ofstream file(temporary.name(), std::ios::binary | std::ios::trunc);
  if (!file) throw fail("cannot be created");
  write(file);
  file.close();
  if (!file || !sync_file(temporary.name())) throw fail("cannot be written");
  temporary.publish();
}

void write_file_atomically(const std::string& path, const std::string& content) {
  write_file_atomically(path, [&content](std::ostream& out) { out << content; });
}

}  // namespace slalom
