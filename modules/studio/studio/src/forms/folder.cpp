// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/studio/folder.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// With a slash at its end; empty for the current folder.
std::string parent_of(const std::string& folder) {
  const std::string parent = (fs::path(folder) / "..").lexically_normal().string();
  if (parent == ".") return "";
  return ends_with(parent, "/") ? parent : parent + "/";
}

bool is_root(const fs::path& folder) {
  std::error_code error;
  return fs::absolute(folder, error).lexically_normal().relative_path().empty();
}

}  // namespace

std::size_t begin_of_last_path(const std::string& paths) {
  return std::min(paths.find_first_not_of(' ', paths.rfind(',') + 1), paths.size());
}

std::string folder_of(const std::string& path) {
  return path.substr(0, path.rfind('/') + 1);  // npos + 1 is 0
}

FolderContent content_of_folder(const std::string& folder,
                                const std::vector<std::string>& extensions) {
  const fs::path path = folder.empty() ? "." : folder;
  const auto has_extension = [&](const std::string& name) {
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const std::string& extension) { return ends_with(name, extension); });
  };
  FolderContent content;
  std::error_code error, unknown;
  for (fs::directory_iterator entry(path, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const bool is_folder = entry->is_directory(unknown);
    const bool is_file = entry->is_regular_file(unknown) && has_extension(name);
    if (!starts_with(name, ".") && (is_folder || is_file))
      content.entries.push_back({name, is_folder});
  }
  std::sort(content.entries.begin(), content.entries.end(), [](const auto& a, const auto& b) {
    return std::tie(b.is_folder, a.name) < std::tie(a.is_folder, b.name);
  });
  if (!is_root(path)) content.entries.insert(content.entries.begin(), {"..", true});
  if (error) content.error = job_error(path.string(), error.message(), "a readable folder").what();
  return content;
}

std::string path_to_entry(const std::string& path, const FolderEntry& entry) {
  const std::string folder = folder_of(path), name = path.substr(folder.size());
  if (!entry.is_folder) return folder + entry.name;
  std::error_code unknown;
  const bool is_new = !starts_with(entry.name, name) && !fs::exists(path, unknown);
  return (entry.name == ".." ? parent_of(folder) : folder + entry.name + "/") +
         (is_new ? name : "");
}

}  // namespace slalom
