// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/adapters.h>
#include <slalom/app/external_options.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>
#include <slalom/methods/registry.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

constexpr char kTune[] = "tune";

/// A library that comes with Slalom, by its name or its path. One that does not exist is none.
bool is_shipped(IniFile ini, const ExternalOption& option) try {
  ini.set(option.section, option.key, option.value);
  const std::filesystem::path path = resolve_plugin_path(ini, option.section, option.key);
  std::error_code ignored;
  return contains(shipped_plugins(), path.filename().string()) &&
         std::filesystem::equivalent(path.parent_path(), shipped_folder(), ignored);
} catch (const Error&) {
  return false;
}

bool is_foreign(const IniFile& ini, const ExternalOption& option) {
  switch (option.use) {
    case External::File:
      return false;
    case External::Library:
      return !is_shipped(ini, option);
    case External::Address:  // other providers of LCM write files
      return option.value.find(':') != std::string::npos && !starts_with(option.value, "udpm:") &&
             !starts_with(option.value, "memq:");
    default:
      return true;
  }
}

/// Values that [tune] tries for options of methods: a search builds a method with each of them.
std::vector<ExternalOption> tuned_options(const IniFile& ini,
                                          const std::vector<std::string>& sections) {
  std::vector<ExternalOption> options;
  for (const std::string& section : sections)
    for (const std::string& key : ini.keys(kTune))
      if (const External use = external_use(ini, section, key); use != External::None)
        for (const std::string& value : split(ini.get(kTune, key).value_or(""), '|'))
          options.push_back({section, key, value, use});
  return options;
}

std::string path_of(const IniFile& ini, const ExternalOption& option) {
  switch (option.use) {
    case External::Library:
      return resolve_plugin_path(ini, option.section, option.key);
    case External::Code:
    case External::File:
      return resolve_method_file(option.key, option.value, ini.folder(),
                                 ini.where(option.section, option.key));
    default:
      return "";
  }
}

}  // namespace

std::vector<ExternalOption> external_options(const IniFile& ini,
                                             const std::vector<std::string>& sections) {
  std::vector<ExternalOption> options;
  for (const std::string& section : sections)
    for (const std::string& key : ini.keys(section)) {
      const External use = external_use(ini, section, key);
      const std::string value = ini.get(section, key).value_or("");
      if (use != External::None && !value.empty()) options.push_back({section, key, value, use});
    }
  return options;
}

bool is_location(const IniFile& ini, const std::string& section, const std::string& key) {
  const External use = external_use(ini, section, key);
  return use != External::None && use != External::Command;
}

std::map<std::string, std::string> files_of_methods(const IniFile& ini,
                                                    const std::vector<std::string>& sections) {
  std::map<std::string, std::string> files;
  for (const ExternalOption& option : external_options(ini, sections))
    if (const std::string path = path_of(ini, option); !path.empty())
      files[option.section + "." + option.key] = path;
  return files;
}

void require_no_foreign_code(const IniFile& ini, std::vector<std::string> sections,
                             const std::string& file, const std::string& expected) {
  if (sections.empty())
    for (const std::string& section : ini.sections())
      if (starts_with(section, "method.")) sections.push_back(section);
  std::vector<std::string> foreign;
  const auto judge = [&](const ExternalOption& option, const std::string& section) {
    if (!ini.is_overridden(section, option.key) && is_foreign(ini, option))
      foreign.push_back(option.section + ": " + option.key + " = " + option.value);
  };
  for (const ExternalOption& option : external_options(ini, sections))
    judge(option, option.section);
  for (const ExternalOption& option : tuned_options(ini, sections)) judge(option, kTune);
  if (!foreign.empty())
    throw usage_error(file,
                      "its methods would execute what the file names (" + join(foreign, ", ") + ")",
                      expected);
}

}  // namespace slalom
