// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// The folder for a navigator's collision grids during its initialization. An empty `folder` means
/// a temporary one that is removed with this object. Otherwise it is a permanent subfolder for this
/// content of the .ini, locked against other processes during the lifetime of this object.
class PtgCacheFolder {
 public:
  /// Throws std::runtime_error if the folder cannot be created or locked.
  PtgCacheFolder(const std::string& folder, const std::string& content);
  ~PtgCacheFolder();
  PtgCacheFolder(const PtgCacheFolder&) = delete;
  PtgCacheFolder& operator=(const PtgCacheFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int lock_ = -1;  ///< descriptor of the lock file; -1: the folder is temporary
};

}  // namespace slalom
