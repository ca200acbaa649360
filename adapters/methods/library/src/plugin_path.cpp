// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/program_path.h>
#include <slalom/library/library_method.h>
#include <slalom/methods/registry.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace slalom {
namespace {

std::string stated_folder;

}  // namespace

std::string resolve_plugin_path(const std::string& plugin, const std::string& folder,
                                const std::string& where) {
  return resolve_method_file("library", plugin, folder, where,
                             {shipped_folder(), program_folder() + "/../lib"});
}

void set_shipped_folder(const std::string& folder) {
  stated_folder = folder;
}

std::string shipped_folder() {
  if (!stated_folder.empty()) return stated_folder;
  return (std::filesystem::path(program_folder()) / "../lib/slalom").string();
}

std::vector<std::string> shipped_plugins() {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator file(shipped_folder(), error), end; !error && file != end;
       file.increment(error))
    if (file->path().extension() == ".so" || file->path().extension() == ".dll")
      names.push_back(file->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string resolve_plugin_path(const IniFile& ini, const std::string& section,
                                const std::string& key) {
  return resolve_plugin_path(ini.get(section, key).value_or(""), ini.folder(),
                             ini.where(section, key));
}

}  // namespace slalom
