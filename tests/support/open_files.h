// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <dirent.h>
#include <vector>

namespace slalom {

/// The open descriptors except the one that lists them.
inline std::vector<int> open_files() {
  std::vector<int> files;
  DIR* folder = opendir("/proc/self/fd");
  while (const dirent* entry = readdir(folder)) {
    const int file = std::atoi(entry->d_name);
    if (entry->d_name[0] != '.' && file != dirfd(folder)) files.push_back(file);
  }
  closedir(folder);
  return files;
}

}  // namespace slalom
