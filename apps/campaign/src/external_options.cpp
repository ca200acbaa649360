#include <slalom/app/external_options.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>
#include <slalom/methods/registry.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

/// The external options of all adapters; a new one is registered here.
struct ExternalKey {
  const char *adapter, *key;
  ExternalUse use;
};
constexpr ExternalKey kExternalKeys[] = {
    {"library", "plugin", ExternalUse::Load},
    {"mrpt_holonomic", "plugin", ExternalUse::Load},
    {"mrpt_holonomic", "config", ExternalUse::Read},
    {"mrpt_navigator", "plugin", ExternalUse::Load},
    {"mrpt_navigator", "modules", ExternalUse::Load},
    {"mrpt_navigator", "config", ExternalUse::Read},
    {"mrpt_navigator", "ptg_cache", ExternalUse::Write},
    {"mrpt_navigator", "record_navlog", ExternalUse::Write},
    {"python", "module", ExternalUse::Load},
    {"onnx", "model", ExternalUse::Load},
    {"onnx", "runtime", ExternalUse::Load},
    {"lcm", "launch", ExternalUse::Execute},
    {"lcm", "url", ExternalUse::Connect},
    {"lcm", "channel", ExternalUse::Connect},
};

const ExternalKey* external_key(const IniFile& ini, const std::string& section,
                                const std::string& key) {
  const std::string adapter = ini.get(section, "adapter").value_or("");
  for (const ExternalKey& row : kExternalKeys)
    if (adapter == row.adapter && key == row.key) return &row;
  return nullptr;
}

std::string folder_of(const IniFile& ini) {
  return std::filesystem::path(ini.name()).parent_path().string();
}

/// A library that comes with Slalom, by its name or its path.
bool is_shipped(const IniFile& ini, const ExternalOption& option) {
  const std::filesystem::path path = resolve_plugin_path(ini, option.section, option.value);
  std::error_code ignored;
  return contains(shipped_plugins(), path.filename().string()) &&
         std::filesystem::equivalent(path.parent_path(), shipped_folder(), ignored);
}

bool is_foreign(const IniFile& ini, const ExternalOption& option) {
  switch (option.use) {
    case ExternalUse::Read:
      return false;
    case ExternalUse::Load:
      return option.key != "plugin" || !is_shipped(ini, option);
    case ExternalUse::Connect:  // other providers of LCM write files
      return option.key == "url" && !starts_with(option.value, "udpm:") &&
             !starts_with(option.value, "memq:");
    default:
      return true;
  }
}

}  // namespace

std::vector<ExternalOption> external_options(const IniFile& ini,
                                             const std::vector<std::string>& sections) {
  std::vector<ExternalOption> options;
  for (const std::string& section : sections)
    for (const std::string& key : ini.keys(section)) {
      const ExternalKey* const known = external_key(ini, section, key);
      const std::string value = ini.get(section, key).value_or("");
      if (known != nullptr && !value.empty()) options.push_back({section, key, value, known->use});
    }
  return options;
}

bool is_location(const IniFile& ini, const std::string& section, const std::string& key) {
  const ExternalKey* const known = external_key(ini, section, key);
  return known != nullptr && known->use != ExternalUse::Execute;
}

std::map<std::string, std::string> files_of_methods(const IniFile& ini,
                                                    const std::vector<std::string>& sections) {
  std::map<std::string, std::string> files;
  for (const ExternalOption& option : external_options(ini, sections)) {
    const std::string& key = option.key;
    std::string path;
    if (key == "plugin") path = resolve_plugin_path(ini, option.section, option.value);
    if (key == "module" || key == "model")
      path = resolve_method_file(key, option.value, folder_of(ini), ini.where(option.section, key));
    if (key == "config") path = option.value;
    if (!path.empty()) files[option.section + "." + key] = path;
  }
  return files;
}

void require_no_foreign_code(const IniFile& ini, std::vector<std::string> sections,
                             const std::string& file) {
  if (sections.empty())
    for (const std::string& section : ini.sections())
      if (starts_with(section, "method.")) sections.push_back(section);
  std::vector<std::string> foreign;
  for (const ExternalOption& option : external_options(ini, sections)) {
    if (starts_with(ini.where(option.section, option.key), "--set")) continue;
    if (is_foreign(ini, option))
      foreign.push_back(option.section + ": " + option.key + " = " + option.value);
  }
  if (!foreign.empty())
    throw usage_error(file,
                      "its methods would execute what the file names (" + join(foreign, ", ") + ")",
                      "-c with an .ini of your own, or --trust if you trust the file");
}

}  // namespace slalom
