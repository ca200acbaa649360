// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/results/repeatability.h>

#include <algorithm>
#include <set>

namespace slalom {
namespace {

/// The order in which differences are named: a changed setting may have changed the scenarios too.
int rank_of(const std::string& key) {
  if (starts_with(key, "scenarios.")) return 2;
  return starts_with(key, "version.") ? 1 : 0;
}

constexpr const char* kAbsent = "absent";
constexpr const char* kHashSuffix = "_hash";

bool is_identity_key(const std::string& key) {
  return starts_with(key, "version.") || starts_with(key, "scenarios.") ||
         starts_with(key, "method.") || starts_with(key, "until") || starts_with(key, kKeptPrefix);
}

/// "plugin of method.nd" for "method.nd.plugin_hash".
std::string file_name(const std::string& key) {
  const std::string path = key.substr(0, key.size() - std::string(kHashSuffix).size());
  // Neither names of options nor sections contain a slash, which begins the name of a file.
  const std::size_t dot = path.rfind('.', path.find('/'));
  return path.substr(dot + 1) + " of " + path.substr(0, dot);
}

std::string text_of(const std::map<std::string, std::string>& parts, const std::string& key) {
  const auto found = parts.find(key);
  if (found == parts.end()) return kAbsent;
  return found->second.empty() ? "empty" : found->second;
}

}  // namespace

std::map<std::string, std::string> identity_parts(const Manifest& manifest) {
  std::map<std::string, std::string> parts;
  for (const auto& [key, text] : manifest)
    if (is_identity_key(key)) parts[key] = text;
  const auto text = manifest.find(kEffectiveKey);
  if (text == manifest.end()) return parts;
  const IniFile ini = IniFile::from_text(text->second, kEffectiveKey);
  for (const std::string& section : ini.sections())
    for (const std::string& key : ini.keys(section))
      parts[section + "." + key] = ini.get(section, key).value_or("");
  return parts;
}

std::string campaign_identity(const Manifest& manifest) {
  Hasher hasher;
  for (const auto& [key, text] : identity_parts(manifest)) hasher.add(key).add(text);
  return hasher.hex();
}

std::vector<IdentityDifference> identity_differences(const Manifest& here, const Manifest& there) {
  const auto first = identity_parts(here), second = identity_parts(there);
  std::set<std::pair<int, std::string>> keys;
  for (const auto* parts : {&first, &second})
    for (const auto& [key, text] : *parts) keys.insert({rank_of(key), key});
  std::vector<IdentityDifference> differences;
  for (const auto& [rank, key] : keys) {
    IdentityDifference found{key, text_of(first, key), text_of(second, key)};
    if (found.here != found.there) differences.push_back(std::move(found));
  }
  return differences;
}

std::string to_string(const IdentityDifference& difference, const std::string& file) {
  const auto& [key, here, there] = difference;
  if (is_method_file(key) && here != kAbsent && there != kAbsent)
    return file_name(key) + " is not the one of " + file;
  return key + " is " + here + " here and " + there + " in " + file;
}

std::string enumerate(const std::vector<IdentityDifference>& differences, const std::string& file) {
  constexpr std::size_t kMaxNamed = 3;
  std::vector<std::string> named;
  for (const IdentityDifference& difference : differences)
    if (named.size() < kMaxNamed) named.push_back(to_string(difference, file));
  const std::size_t more = differences.size() - named.size();
  return join(named, ", ") +
         (more == 0 ? "" : ", and " + std::to_string(more) + " more differences");
}

bool is_method_file(const std::string& key) {
  const std::string suffix = kHashSuffix;
  return starts_with(key, "method.") && key.size() > suffix.size() &&
         key.compare(key.size() - suffix.size(), suffix.size(), suffix) == 0;
}

void expect_same_campaign(const Manifest& here, const Manifest& there, const std::string& file,
                          const std::string& remedy) {
  if (there.count(kEffectiveKey) == 0)
    throw file_error(file, "does not say which campaign it holds", remedy);
  const std::vector<IdentityDifference> differences = identity_differences(here, there);
  if (!differences.empty())
    throw file_error(file, "holds another campaign: " + enumerate(differences, file), remedy);
}

bool mixes_versions(const Manifest& manifest, const std::string& method) {
  const std::string prefix = std::string(kKeptPrefix) + "method." + method + ".";
  const auto found = manifest.lower_bound(prefix);
  return found != manifest.end() && starts_with(found->first, prefix);
}

void add_repeated_runs(const Manifest& from, Manifest& to) {
  for (const auto& [key, difference] : from)
    if (const std::string method = repeated_method(key);
        !method.empty() && !mixes_versions(to, method))
      to[key] = difference;
}

std::vector<std::string> kept_run_notes(const Manifest& manifest) {
  std::vector<std::string> notes;
  for (const auto& [key, text] : manifest)
    if (starts_with(key, kKeptPrefix))
      notes.push_back("runs of several versions are mixed: " +
                      file_name(key.substr(std::string(kKeptPrefix).size())) +
                      " was replaced (before: " + text + ")");
  return notes;
}

}  // namespace slalom
