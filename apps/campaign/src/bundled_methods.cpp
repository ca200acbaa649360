// SPDX-License-Identifier: BSD-3-Clause
#include "verify_plan.h"

#include <slalom/app/adapters.h>
#include <slalom/app/bundled_methods.h>
#include <slalom/app/method_dependencies.h>
#include <slalom/app/output_folder.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/printable.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/library/library_method.h>
#include <slalom/methods/registry.h>
#include <slalom/results/recorded_ini.h>

#include <fmt/format.h>

#include <filesystem>

namespace slalom {
namespace {

namespace fs = std::filesystem;

bool is_shipped_file(const std::string& path) {
  std::error_code ignored;
  return fs::equivalent(fs::path(path).parent_path(), shipped_folder(), ignored);
}

/// The file of an option, "method.mine.plugin", or one that it needs, "method.mine.module/util.py".
struct BundledName {
  explicit BundledName(const std::string& key) {
    const std::size_t slash = key.find('/');
    const std::string name = key.substr(0, slash);
    section = name.substr(0, name.rfind('.'));
    option = name.substr(name.rfind('.') + 1);
    if (slash != std::string::npos) needed = key.substr(slash + 1);
  }

  std::string section, option, needed;
};

/// The place of a file in the folder of its section. Throws Error (File) for one outside.
fs::path place_of(const std::string& name, const std::string& bundle) {
  const fs::path path = fs::path(name).lexically_normal();
  if (path.empty() || path.is_absolute() || *path.begin() == ".." || !path.has_filename())
    throw file_error(bundle, "contains a file '" + name + "' outside of its folder",
                     "a bundle written by Slalom");
  return path;
}

/// An option that the method itself reads, which finds the file under its absolute path only.
bool is_own_option(const IniFile& ini, const BundledName& name) {
  return ini.get(name.section, name.option).has_value() &&
         external_use(ini, name.section, name.option) == External::None;
}

/// Throws Error (Usage) for a folder that no option can name.
std::string absolute_path(const std::string& folder, const fs::path& place) {
  const std::string path = fs::absolute(folder / place).string();
  if (!IniFile::can_hold(path))
    throw usage_error(folder, "cannot be named in an .ini file", "a path without # and ;");
  return path;
}

std::vector<BundledFile> files_of(const CampaignConfig& config, Manifest manifest,
                                  const std::string& results) {
  std::vector<BundledFile> found;
  for (const auto* files : {&config.method_files, &config.dependencies})
    for (const auto& [key, path] : *files) {
      if (is_shipped_file(path)) continue;
      found.push_back({key, read_file(path, "a file of a method")});
      if (Hasher().add(found.back().content).hex() != manifest[key + "_hash"])
        throw job_error(path, "has changed since the runs of " + results + " were executed",
                        "the file with which they were executed, or no --with-sources");
    }
  return found;
}

}  // namespace

std::string write_campaign_bundle(const std::string& results, const std::string& path,
                                  const CampaignConfig& config, bool with_sources) {
  BundleOptions options;
  std::size_t runs = 0;
  {
    const ResultFile file = ResultFile::open(results);
    const PlanComparison plan = compare_plan(file, config);
    if (!plan.complete())
      throw usage_error(results, plan.text(), "the results of a whole campaign");
    runs = plan.present;
    if (with_sources) options.files = files_of(config, file.read_manifest(), results);
  }
  write_bundle(results, path, options);
  return fmt::format("{}: {}, {:.1f} MB", path, count_text(runs, "run"),
                     static_cast<double>(fs::file_size(path)) / kMegabyte);
}

std::string unpack_methods(const std::string& bundle, const std::string& folder) {
  IniFile ini = recorded_ini(ResultFile::open(bundle).read_manifest(), bundle);
  for (const BundledFile& file : read_bundled_files(bundle)) {
    const BundledName name(file.key);
    if (!starts_with(name.section, "method.") || !ini.has_section(name.section))
      throw file_error(bundle, "contains a file of '" + printable_line(file.key) + "'",
                       "a file of a method of its campaign");
    const bool is_option = name.needed.empty();
    const std::string value = ini.get(name.section, name.option).value_or("");
    const fs::path place =
        fs::path(place_of(name.section, bundle)) /
        place_of(is_option ? fs::path(value).filename().string() : name.needed, bundle);
    make_output_folder((folder / place).parent_path().string());
    write_file_atomically((folder / place).string(), file.content);
    if (is_option)
      ini.set(name.section, name.option, place.string());
    else if (is_own_option(ini, name))
      ini.set(name.section, name.option, with_named_file(value, absolute_path(folder, place)));
  }
  const std::string path = (fs::path(folder) / "campaign.ini").string();
  write_file_atomically(path, ini.canonical_text());
  return path;
}

}  // namespace slalom
