// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/expect_text.h>
#include <slalom/core/read_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace slalom {
namespace {

const char* type_name(mode_t mode) {
  if (S_ISDIR(mode)) return "folder";
  if (S_ISFIFO(mode)) return "pipe";
  if (S_ISSOCK(mode)) return "socket";
  return "device";
}

/// An open file that is regular and not larger than allowed when it is opened.
class InputFile {
 public:
  InputFile(const std::string& path, const std::string& kind, std::uint64_t max_size)
      : path_(path), kind_(kind), max_size_(max_size) {
    // Opening a pipe would otherwise wait for its writer.
    file_ = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    struct stat status = {};
    if (file_ < 0 || fstat(file_, &status) != 0) {
      const int reason = errno;
      close_file();
      throw file_error(path, std::string("cannot be read (") + std::strerror(reason) + ")", kind);
    }
    size_ = static_cast<std::uint64_t>(status.st_size);
    if (S_ISREG(status.st_mode) && size_ <= max_size) return;
    close_file();
    if (S_ISREG(status.st_mode)) throw too_large();
    throw file_error(path, std::string("cannot be read (is a ") + type_name(status.st_mode) + ")",
                     expected());
  }
  ~InputFile() { close_file(); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Reads to the end, which may be farther than the size: files of the system have size 0.
  std::string read_all() {
    constexpr std::size_t kBlock = 1U << 16U;
    std::string content;
    content.reserve(static_cast<std::size_t>(size_) + kBlock);
    while (true) {
      const std::size_t begin = content.size();
      content.resize(std::max(begin + kBlock, static_cast<std::size_t>(size_)));
      const ssize_t got = read(file_, &content[begin], content.size() - begin);
      const int reason = errno;
      content.resize(begin + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
      if (got == 0) return content;
      if (got < 0 && reason != EINTR)
        throw file_error(path_, std::string("cannot be read (") + std::strerror(reason) + ")",
                         kind_);
      if (content.size() > max_size_) throw too_large();
    }
  }

 private:
  std::string expected() const {
    if (max_size_ == std::numeric_limits<std::uint64_t>::max()) return kind_ + ", a regular file";
    return fmt::format("{}, a regular file of at most {} MB", kind_, max_size_ / kMegabyte);
  }
  Error too_large() const { return file_error(path_, "is too large", expected()); }
  void close_file() {
    if (file_ >= 0) close(file_);
    file_ = -1;
  }

  const std::string& path_;
  const std::string& kind_;
  std::uint64_t max_size_, size_ = 0;  ///< bytes
  int file_ = -1;
};

}  // namespace

std::string read_file(const std::string& path, const std::string& kind, std::uint64_t max_size) {
  return InputFile(path, kind, max_size).read_all();
}

std::string read_text(const std::string& path, const std::string& kind, std::uint64_t max_size) {
  constexpr char kByteOrderMark[] = "\xEF\xBB\xBF";  // of UTF-8
  std::string text = read_file(path, kind, max_size);
  if (text.compare(0, 3, kByteOrderMark) == 0) text.erase(0, 3);
  return text;
}

std::string read_utf8(const std::string& path, const std::string& kind, std::uint64_t max_size) {
  std::string text = read_text(path, kind, max_size);
  expect_utf8(text, path, kind);
  return text;
}

void require_regular_file(const std::string& path, const std::string& kind,
                          std::uint64_t max_size) {
  InputFile(path, kind, max_size);
}

}  // namespace slalom
