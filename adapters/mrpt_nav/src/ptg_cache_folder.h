#pragma once

#include <string>

namespace slalom {

/// Where a navigator puts its collision grids while it is initialised. Without a `folder`: a
/// temporary one of its own that goes with this object. With one: a folder in it for this content
/// of the .ini only, kept, and locked against other processes as long as this object lives.
class PtgCacheFolder {
 public:
  /// Throws std::runtime_error when the folder cannot be made or locked.
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
