#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>
#include <slalom/io/campaign_identity.h>

#include <algorithm>
#include <set>

namespace slalom {
namespace {

/// The order in which differences are named: a changed setting may have changed the scenarios too.
int rank_of(const std::string& key) {
  if (starts_with(key, "scenarios.")) return 2;
  return starts_with(key, "version.") ? 1 : 0;
}

bool is_identity_key(const std::string& key) {
  return starts_with(key, "version.") || starts_with(key, "scenarios.") ||
         starts_with(key, "method.") || starts_with(key, "until");
}

std::string text_of(const std::map<std::string, std::string>& parts, const std::string& key) {
  const auto found = parts.find(key);
  if (found == parts.end()) return "absent";
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

std::vector<std::string> identity_differences(const Manifest& here, const Manifest& there,
                                              const std::string& file) {
  const auto first = identity_parts(here), second = identity_parts(there);
  if (there.count(kEffectiveKey) == 0) return {file + " does not say which campaign it holds"};
  std::set<std::pair<int, std::string>> keys;
  for (const auto* parts : {&first, &second})
    for (const auto& [key, text] : *parts) keys.insert({rank_of(key), key});
  std::vector<std::string> differences;
  for (const auto& [rank, key] : keys) {
    const std::string a = text_of(first, key), b = text_of(second, key);
    if (a != b) differences.push_back(key + " is " + a + " here and " + b + " in " + file);
  }
  return differences;
}

void expect_same_campaign(const Manifest& here, const Manifest& there, const std::string& file,
                          const std::string& remedy) {
  constexpr std::size_t kMaxNamed = 3;
  std::vector<std::string> differences = identity_differences(here, there, file);
  if (differences.empty()) return;
  const std::size_t more = differences.size() - std::min(differences.size(), kMaxNamed);
  differences.resize(differences.size() - more);
  throw file_error(file,
                   "holds another campaign: " + join(differences, ", ") +
                       (more == 0 ? "" : ", and " + std::to_string(more) + " more differences"),
                   remedy);
}

}  // namespace slalom
