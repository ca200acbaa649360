// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/program_path.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace slalom {

std::string resolve_plugin_path(const std::string& plugin, const std::string& folder,
                                const std::string& where) {
  namespace fs = std::filesystem;
  const fs::path requested(plugin);
  std::vector<fs::path> candidates = {requested};
  if (requested.is_relative()) {
    const fs::path program = program_folder();
    candidates = {fs::path(folder) / requested, requested, program / "../lib/slalom" / requested,
                  program / "../lib" / requested};
  }
  std::vector<std::string> tried;
  for (const fs::path& candidate : candidates) {
    std::error_code ignored;
    const fs::path path = fs::absolute(candidate).lexically_normal();
    if (fs::is_regular_file(path, ignored)) return path.string();
    if (!contains(tried, path.string())) tried.push_back(path.string());
  }
  throw usage_error(where, "library '" + plugin + "' not found",
                    "a file at " + join(tried, " or "));
}

std::string shipped_folder() {
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
