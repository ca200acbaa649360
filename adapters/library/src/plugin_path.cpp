#include "shared_library.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>

#include <filesystem>
#include <system_error>
#include <vector>

namespace slalom {

std::string resolve_plugin_path(const IniFile& ini, const std::string& section,
                                const std::string& plugin) {
  namespace fs = std::filesystem;
  const fs::path wanted(plugin);
  std::vector<fs::path> candidates = {wanted};
  if (wanted.is_relative()) {
    const fs::path program = program_folder();
    candidates = {fs::path(ini.name()).parent_path() / wanted, wanted,
                  program / "../lib/slalom" / wanted, program / "../lib" / wanted};
  }
  std::vector<std::string> looked;
  for (const fs::path& candidate : candidates) {
    std::error_code ignored;
    const fs::path whole = fs::absolute(candidate).lexically_normal();
    if (fs::is_regular_file(whole, ignored)) return whole.string();
    looked.push_back(whole.string());
  }
  throw usage_error(ini.where(section, "plugin"), "no library '" + plugin + "'",
                    "a file at " + join(looked, " or "));
}

}  // namespace slalom
