// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// A file or folder in a folder.
struct FolderEntry {
  std::string name;  ///< ".." for the parent folder
  bool is_folder = false;
};

struct FolderContent {
  std::vector<FolderEntry> entries;
  std::string error;  ///< why the folder cannot be read; empty if it can
};

/// The position in comma-separated paths at which the last one begins, behind blanks.
std::size_t begin_of_last_path(const std::string& paths);

/// The beginning of a path up to its last slash; empty for the current folder.
std::string folder_of(const std::string& path);

/// The entries of a folder, "" for the current one: ".." unless it is the root, then folders, then
/// the files whose names end in one of `extensions`, each sorted by name. Hidden ones (".git") are
/// left out. A folder that cannot be read has ".." only.
FolderContent content_of_folder(const std::string& folder,
                                const std::vector<std::string>& extensions);

/// The path after an entry of its folder was chosen. A folder ends with a slash; the name of a new
/// file is kept behind it.
std::string path_to_entry(const std::string& path, const FolderEntry& entry);

}  // namespace slalom
