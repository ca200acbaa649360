#include <slalom/core/error.h>
#include <slalom/io/result_file.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace slalom {
namespace {

/// Writes all bytes and syncs the file; on failure, returns false with errno set.
bool write_and_sync(int file, const std::string& content) {
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t written = write(file, content.data() + done, content.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    done += static_cast<std::size_t>(written);
  }
  return fsync(file) == 0;
}

}  // namespace

void write_file_atomically(const std::string& path, const std::string& content) {
  const std::string temporary = path + ".tmp" + std::to_string(getpid());
  const auto fail = [&](const char* what) {
    const std::string reason = std::strerror(errno);
    unlink(temporary.c_str());
    return job_error(path, std::string(what) + " (" + reason + ")", "a writable path");
  };
  const int file = open(temporary.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0644);
  if (file < 0) throw fail("cannot be created");
  const bool written = write_and_sync(file, content);
  const int write_errno = errno;
  close(file);
  errno = write_errno;
  if (!written) throw fail("cannot be written");
  if (rename(temporary.c_str(), path.c_str()) != 0) throw fail("cannot be replaced");
}

}  // namespace slalom
