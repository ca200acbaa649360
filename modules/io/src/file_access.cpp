#include <slalom/core/error.h>
#include <slalom/io/result_file.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
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
  const std::string temporary = path + ".tmp" + std::to_string(getpid());
  const auto fail = [&](const char* what) {
    const std::string reason = std::strerror(errno);
    unlink(temporary.c_str());
    return job_error(path, std::string(what) + " (" + reason + ")", "a writable path");
  };
  std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
  if (!file) throw fail("cannot be created");
  try {
    write(file);
  } catch (...) {
    unlink(temporary.c_str());
    throw;
  }
  file.close();
  if (!file || !sync_file(temporary)) throw fail("cannot be written");
  if (rename(temporary.c_str(), path.c_str()) != 0) throw fail("cannot be replaced");
}

void write_file_atomically(const std::string& path, const std::string& content) {
  write_file_atomically(path, [&content](std::ostream& out) { out << content; });
}

}  // namespace slalom
