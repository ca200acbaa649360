// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/open_results.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/merge_results.h>

#include <algorithm>
#include <map>

namespace slalom {
namespace {

using Differences = std::vector<IdentityDifference>;

constexpr const char* kRemedy =
    "the same campaign, one that only adds scenarios, methods or repetitions, another output, or "
    "--overwrite to start over";

/// Differences between a campaign and the one of a file, by kind.
struct Changes {
  Differences replaced;   ///< files of methods
  Differences additions;  ///< of scenarios, methods, repetitions
  Differences others;
};

std::vector<std::string> sorted_list(const std::string& text) {
  std::vector<std::string> names = split(text, ',');
  std::sort(names.begin(), names.end());
  return names;
}

bool adds_methods(const std::string& here, const std::string& there) {
  const std::vector<std::string> all = sorted_list(here), old = sorted_list(there);
  return std::includes(all.begin(), all.end(), old.begin(), old.end());
}

bool adds_repetitions(const std::string& here, const std::string& there) {
  long long all = 0, old = 0;
  return parse_integer(here, all) && parse_integer(there, old) && all > old;
}

/// Whether the key is of a method, but none of these; their names may contain dots.
bool is_of_new_method(const std::string& key, const std::vector<std::string>& old_methods) {
  return starts_with(key, "method.") &&
         std::none_of(old_methods.begin(), old_methods.end(), [&](const std::string& method) {
           return starts_with(key, "method." + method + ".");
         });
}

bool is_addition(const IdentityDifference& difference,
                 const std::vector<std::string>& old_methods) {
  const auto& [key, here, there] = difference;
  if (key == "campaign.methods") return adds_methods(here, there);
  if (key == "campaign.repetitions") return adds_repetitions(here, there);
  // Scenarios are compared one by one.
  return starts_with(key, "scenarios.") || is_of_new_method(key, old_methods);
}

Changes find_changes(const Manifest& manifest, const Manifest& stored) {
  const std::map<std::string, std::string> parts = identity_parts(stored);
  const auto methods = parts.find("campaign.methods");
  const std::vector<std::string> old_methods =
      methods == parts.end() ? std::vector<std::string>() : split(methods->second, ',');
  Changes changes;
  for (const IdentityDifference& difference : identity_differences(manifest, stored)) {
    const bool is_new = is_of_new_method(difference.key, old_methods);
    auto& kind = is_method_file(difference.key) && !is_new ? changes.replaced
                 : is_addition(difference, old_methods)    ? changes.additions
                                                           : changes.others;
    kind.push_back(difference);
  }
  return changes;
}

void expect_same_shard(const std::string& path, Manifest manifest, Manifest stored) {
  const std::string shard = stored[kShardKey];
  if (shard != manifest[kShardKey])
    throw file_error(path, "contains " + (shard.empty() ? "no shard" : "shard " + shard),
                     "another file, or --overwrite to start over");
}

/// Throws Error (File) unless each scenario of the file is one of these, by content and name.
void expect_known_scenarios(const ResultFile& file, const std::vector<Scenario>& scenarios) {
  std::map<std::string, std::string> names;
  for (const Scenario& scenario : scenarios) names[scenario.hash()] = scenario.name();
  for (const auto& [hash, name] : file.read_scenario_names()) {
    const auto found = names.find(hash);
    if (found != names.end() && found->second == name) continue;
    throw file_error(file.path(),
                     "holds another campaign: its scenario " + name + " (" + hash.substr(0, 8) +
                         (found == names.end() ? ") is none of those here"
                                               : ") is called " + found->second + " here"),
                     kRemedy);
  }
}

void expect_extension(const ResultFile& file, const Changes& changes, const Manifest& manifest,
                      const std::vector<Scenario>& scenarios) {
  if (!changes.others.empty())
    throw file_error(file.path(),
                     "holds another campaign: " + enumerate(changes.others, file.path()), kRemedy);
  if (changes.additions.empty()) return;
  // A stopping rule decides by the order of all scenarios and the number of methods.
  if (manifest.count("until") > 0)
    throw file_error(file.path(),
                     "was made with --until, which cannot be extended: " +
                         enumerate(changes.additions, file.path()),
                     "another output, or --overwrite to start over");
  expect_known_scenarios(file, scenarios);
}

/// Stores in the manifest that the runs of the file were made with other files of methods.
void note_replaced_files(const ResultFile& file, const Differences& replaced, Manifest& manifest) {
  std::map<std::string, std::size_t> runs;
  file.for_each_key([&](const std::string&, const std::string& method, int, const std::string&) {
    ++runs[method];
  });
  for (const auto& [key, here, there] : replaced) {
    std::size_t count = 0;
    for (const auto& [method, number] : runs)
      if (starts_with(key, "method." + method + ".")) count = number;
    std::string& text = manifest[kKeptPrefix + key];
    text += (text.empty() ? "" : ", ") + there + " until " + count_text(count, "run");
  }
}

}  // namespace

ResultFile open_results(const std::string& path, Manifest manifest,
                        const std::vector<Scenario>& scenarios, const CampaignOptions& options,
                        ExistingResults existing) {
  const bool exists = ResultFile::exists(path);
  if (!exists && existing == ExistingResults::Require)
    throw file_error(path, "does not exist", "a result file to continue, or no --resume");
  if (!exists || existing == ExistingResults::Overwrite)
    return ResultFile::create(path, manifest, options.descriptor_infos(), options.metric_infos());
  ResultFile file = ResultFile::open(path);
  const Manifest stored = file.read_manifest();
  if (stored.count(kEffectiveKey) == 0)
    throw file_error(path, "does not say which campaign it holds", kRemedy);
  expect_same_shard(path, manifest, stored);
  for (const auto& [key, text] : stored)
    if (starts_with(key, kKeptPrefix)) manifest[key] = text;
  const Changes changes = find_changes(manifest, stored);
  expect_extension(file, changes, manifest, scenarios);
  if (!changes.replaced.empty() && existing != ExistingResults::KeepFinished)
    throw file_error(
        path,
        "its runs were made with another version of a method: " + enumerate(changes.replaced, path),
        "--overwrite to start over, or --keep-finished to keep its runs beside those "
        "of this version");
  if (changes.replaced.empty() && changes.additions.empty()) return file;
  note_replaced_files(file, changes.replaced, manifest);
  add_repeated_runs(stored, manifest);
  manifest[kIdentityKey] = campaign_identity(manifest);
  file.replace_manifest(manifest);
  if (!file.commit()) throw job_error(path, "is being read by another program");
  return file;
}

}  // namespace slalom
