// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/campaign_settings.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>
#include <slalom/results/repeatability.h>

#include <algorithm>
#include <functional>
#include <set>

namespace slalom {
namespace {

constexpr const char* kIniKey = "campaign.ini";

/// The manifest as flat keys, including those of the .ini: "version.mrpt", "sensor.noise_sigma".
std::map<std::string, std::string> settings(const Manifest& manifest) {
  std::map<std::string, std::string> flat;
  for (const auto& [key, text] : manifest) {
    if (key != kIniKey) flat[key] = text;
  }
  const auto text = manifest.find(kIniKey);
  if (text == manifest.end()) return flat;
  const IniFile ini = IniFile::from_text(text->second, kIniKey);
  for (const std::string& section : ini.sections()) {
    for (const std::string& key : ini.keys(section)) {
      flat[section + "." + key] = ini.get(section, key).value_or("");
    }
  }
  return flat;
}

bool cannot_affect_runs(const std::string& key) {
  const auto begins = [&key](const char* prefix) { return starts_with(key, prefix); };
  return key == "seed" || begins("campaign") || begins("analysis.") || begins("record.") ||
         begins(kRepeatedPrefix) || begins("imported_") || begins("scenarios.") ||
         begins("generator.");
}

std::string value_or_default(const std::map<std::string, std::string>& flat,
                             const std::string& key) {
  const auto found = flat.find(key);
  return found == flat.end() ? "(default)" : found->second;
}

/// Whether a key is of a method that the campaign does not run.
bool is_of_missing_method(const std::string& key, const std::map<std::string, std::string>& flat) {
  constexpr char kMethod[] = "method.";
  const auto methods = flat.find("campaign.methods");
  if (!starts_with(key, kMethod) || methods == flat.end()) return false;
  const std::vector<std::string> names = split(methods->second, ',');
  return std::none_of(names.begin(), names.end(), [&](const std::string& name) {
    return starts_with(key, kMethod + name + ".");
  });
}

}  // namespace

std::optional<std::string> campaign_setting(const Manifest& manifest, const std::string& key) {
  const auto flat = settings(manifest);
  const auto found = flat.find(key);
  if (found == flat.end()) return std::nullopt;
  return found->second;
}

std::vector<std::string> campaign_differences(const Manifest& a, const Manifest& b,
                                              const std::vector<std::string>& expected) {
  const auto first = settings(a), second = settings(b);
  std::set<std::string> keys;
  for (const auto& [key, text] : first) keys.insert(key);
  for (const auto& [key, text] : second) keys.insert(key);
  std::vector<std::string> differences;
  for (const std::string& key : keys) {
    if (contains(expected, key) || (cannot_affect_runs(key) && key != "scenarios.hash")) continue;
    if (is_of_missing_method(key, first) || is_of_missing_method(key, second)) continue;
    const std::string before = value_or_default(first, key), after = value_or_default(second, key);
    if (before != after) differences.push_back(key + ": " + before + ", " + after);
  }
  return differences;
}

std::vector<std::string> task_differences(const Manifest& a, const Manifest& b) {
  std::vector<std::string> differences = campaign_differences(a, b, {});
  const auto is_of_task = [](const std::string& difference) {
    const std::string section = difference.substr(0, difference.find('.'));
    return contains({"robot", "sensor", "laser", "odometry", "tracks", "simulation", "people",
                     "reference", "metrics", "limits"},
                    section);
  };
  differences.erase(std::remove_if(differences.begin(), differences.end(), std::not_fn(is_of_task)),
                    differences.end());
  return differences;
}

std::vector<std::string> difference_sentences(const std::vector<ResultTable>& results) {
  std::vector<std::string> sentences;
  for (std::size_t i = 1; i < results.size(); ++i) {
    const ResultTable &a = results[i - 1], &b = results[i];
    const std::string which = results.size() > 2 ? " of " + a.source + " and " + b.source : "";
    for (const std::string& difference : campaign_differences(a.manifest, b.manifest, {}))
      sentences.push_back("the campaigns" + which + " differ: " + difference);
  }
  return sentences;
}

}  // namespace slalom
