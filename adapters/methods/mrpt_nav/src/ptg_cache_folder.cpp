// SPDX-License-Identifier: BSD-3-Clause
#include "ptg_cache_folder.h"

#include <slalom/core/hash.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <stdexcept>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace slalom {
namespace {

namespace fs = std::filesystem;

std::string make_temporary_folder() {
  std::string path = (fs::temp_directory_path() / "slalom-ptg-XXXXXX").string();
  if (mkdtemp(path.data()) != nullptr) return path;
  throw std::runtime_error("cannot create temporary folder " + path + " (" + std::strerror(errno) +
                           ")");
}

int lock_file(const std::string& path) {
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file >= 0 && flock(file, LOCK_EX) == 0) return file;
  const std::string reason = std::strerror(errno);
  if (file >= 0) close(file);
  throw std::runtime_error("'" + path + "' cannot be locked (" + reason + ")");
}

}  // namespace

PtgCacheFolder::PtgCacheFolder(const std::string& folder, const std::string& content) {
  if (folder.empty()) {
    path_ = make_temporary_folder();
    return;
  }
  path_ = (fs::path(folder) / Hasher().add(content).hex()).string();
  fs::create_directories(path_);
  lock_ = lock_file(path_ + "/lock");
}

PtgCacheFolder::~PtgCacheFolder() {
  std::error_code ignored;
  if (lock_ >= 0)
    close(lock_);
  else
    fs::remove_all(path_, ignored);
}

}  // namespace slalom
