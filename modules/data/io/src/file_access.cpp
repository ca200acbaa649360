// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/temporary_file.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
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

/// The kind of a file by its content, as far as it matters; "" for any other text.
const char* kind_of(const std::string& content) {
  const auto begins = [&content](std::string_view magic) { return starts_with(content, magic); };
  if (begins("SQLite format 3")) return "a database";
  if (begins("\x1f\x8b") || begins("PK\x03\x04")) return "a compressed file";
  if (begins("\x7f\x45LF")) return "a library or program";
  if (begins("\x89PNG") || begins("P5") || begins("%PDF")) return "an image";
  for (const std::string& line : split(content, '\n')) {
    if (line.empty() || line.find_first_of(";#@/") == 0) continue;
    const bool is_section = line.front() == '[' && line.back() == ']' &&
                            line.find_first_of("\"{},") == std::string::npos;
    return is_section ? "an .ini" : "";
  }
  return "";
}

std::string kind_of_file(const std::string& path) {
  constexpr std::size_t kHead = 4096;
  std::string head(kHead, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return kind_of(head);
}

/// Only regular files are replaced.
void expect_regular(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) return;
  if (std::filesystem::is_directory(status)) throw job_error(path, "is a folder", "a file");
  if (!std::filesystem::is_regular_file(status))
    throw usage_error(path, "is not a regular file", "a file, or - where that is accepted");
}

/// Files are only replaced by files of their kind.
void expect_same_kind(const std::string& path, const std::string& replacement) {
  std::error_code no_file;
  if (std::filesystem::file_size(path, no_file) == 0 || no_file) return;
  const std::string kind = kind_of_file(path);
  if (kind == kind_of_file(replacement)) return;
  throw usage_error(path, "is " + (kind.empty() ? "a text" : kind) + " and is not replaced",
                    "a new file or one of the same kind");
}

}  // namespace

void write_file_atomically(const std::string& path,
                           const std::function<void(std::ostream&)>& write) {
  expect_regular(path);
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
  expect_same_kind(path, temporary.name());
  temporary.publish();
}

void write_file_atomically(const std::string& path, const std::string& content) {
  write_file_atomically(path, [&content](std::ostream& out) { out << content; });
}

}  // namespace slalom
