#include "draft_file.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace slalom {

Draft::Draft(const std::string& path) : path_(path), name_(path + ".XXXXXX") {
  const int file = mkstemp(name_.data());
  if (file < 0) throw failure("cannot be created");
  fchmod(file, 0644);
  close(file);
}

Draft::~Draft() {
  for (const char* suffix : {"", "-journal"}) unlink((name_ + suffix).c_str());
}

void Draft::publish() {
  sync(name_);
  for (const char* suffix : {"-journal", "-wal", "-shm"}) unlink((path_ + suffix).c_str());
  if (std::rename(name_.c_str(), path_.c_str()) != 0) throw failure("cannot be replaced");
  const auto folder = std::filesystem::path(path_).parent_path();
  sync(folder.empty() ? "." : folder.string());
}

Error Draft::failure(const std::string& what) const {
  return job_error(path_, what + " (" + std::strerror(errno) + ")", "a writable path");
}

void Draft::sync(const std::string& path) const {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && fsync(file) == 0;
  if (file >= 0) close(file);
  if (!done) throw failure("cannot be written");
}

}  // namespace slalom
