// SPDX-License-Identifier: BSD-3-Clause
#include "sibling_temp_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace slalom {

SiblingTempFile::SiblingTempFile(const std::string& path) : path_(path), file_(path) {
  const int file = open(name().c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0644);
  if (file < 0) throw failure("cannot be created");
  close(file);
}

void SiblingTempFile::publish() {
  sync(name());
  for (const char* suffix : {"-journal", "-wal", "-shm"}) unlink((path_ + suffix).c_str());
  file_.publish();
  const auto folder = std::filesystem::path(path_).parent_path();
  sync(folder.empty() ? "." : folder.string());
}

Error SiblingTempFile::failure(const std::string& what) const {
  return job_error(path_, what + " (" + std::strerror(errno) + ")", "a writable path");
}

void SiblingTempFile::sync(const std::string& path) const {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && fsync(file) == 0;
  if (file >= 0) close(file);
  if (!done) throw failure("cannot be written");
}

}  // namespace slalom
