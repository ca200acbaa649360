// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace slalom {

/// Receives one line, for people, about why something takes long.
using LockNotice = std::function<void(const std::string&)>;

/// The right of one program to write a file, kept in a file PATH.lock that names its holder: host,
/// process, job of a cluster. A lock is stale, and is replaced, when its process on this host is
/// gone, or when its job was started again. It is not inherited by forked processes.
class FileLock {
 public:
  /// Throws Error (Job), naming the holder, if another program has the lock. `take_over` takes the
  /// lock of a program on another host that may still be running. `notify` is told when another
  /// program keeps the lock file itself locked, as flock(1) does; after half a minute that is an
  /// error, too.
  explicit FileLock(const std::string& path, bool take_over = false,
                    const LockNotice& notify = nullptr);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::string path_;  ///< of the lock file
  std::string text_;  ///< its content
  int owner_;         ///< process id
};

/// The path of the lock file of an output file.
std::string lock_path(const std::string& path);

/// Who holds the lock of an output file ("process 4711 on node7, job 12"); "" if nobody does, or if
/// the holder is known to be gone.
std::string lock_holder(const std::string& path);

}  // namespace slalom
