// SPDX-License-Identifier: BSD-3-Clause
#include "manifest.h"
#include "verify_plan.h"

#include <slalom/app/method_dependencies.h>
#include <slalom/app/quick_sample.h>
#include <slalom/app/testbeds.h>
#include <slalom/campaign/sequential_campaign.h>
#include <slalom/campaign/shards.h>
#include <slalom/core/error.h>
#include <slalom/core/scratch_folder.h>
#include <slalom/core/text.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/find_run.h>
#include <slalom/io/list_hash.h>
#include <slalom/io/merge_results.h>
#include <slalom/map_formats/map_import.h>

#include <algorithm>
#include <climits>
#include <set>

namespace slalom {
namespace {

std::vector<std::string> hashes_of(const ResultFile& file) {
  std::vector<std::string> hashes;
  for (const auto& [hash, name] : file.read_scenario_names()) hashes.push_back(hash);
  return hashes;
}

RunRecord run_of(const std::string& hash, const std::string& method, int repetition) {
  RunRecord run;
  run.scenario_hash = hash;
  run.method = method;
  run.repetition = repetition;
  return run;
}

/// "robot.max_v was 2 and is 1"
std::string difference_text(const IdentityDifference& difference) {
  return "its manifest states " + difference.key + " = " + difference.there +
         ", its campaign has " + difference.here;
}

/// Whether only the folders of the files differ that the option names; their hashes are compared.
bool differs_in_folders(const IdentityDifference& difference, const Manifest& recorded) {
  std::string here = difference.here, there = difference.there;
  const std::string prefix = difference.key + "/";
  for (auto file = recorded.lower_bound(prefix);
       file != recorded.end() && starts_with(file->first, prefix); ++file) {
    if (!is_method_file(file->first)) continue;
    const std::string path = file->first.substr(0, file->first.rfind('_'));
    const std::string name = path.substr(path.rfind('/') + 1);
    here = with_named_file(here, name);
    there = with_named_file(there, name);
  }
  return here == there;
}

/// Leaves the scenarios of the sample that a manifest states as `text`. Returns why that cannot be:
/// "" if it can.
std::string choose_again(const std::string& text, const CampaignConfig& config, int jobs,
                         Progress& progress, std::vector<Scenario>& scenarios) try {
  long long size = 0;
  parse_integer(text.substr(0, text.find(' ')), size);
  const int wanted = static_cast<int>(std::clamp(size, 0LL, 1LL * INT_MAX));
  const QuickSample sample = choose_quick_sample(scenarios, wanted, config, jobs, progress);
  if (sample.text() != text) return "this version of Slalom chooses " + sample.text();
  scenarios = sampled_scenarios(sample, std::move(scenarios));
  return "";
} catch (const Error& error) {
  if (error.kind() != ErrorKind::Usage) throw;
  return error.what();
}

}  // namespace

std::string PlanComparison::text() const {
  if (is_whole() && !shard.empty()) return "is shard " + shard + " of its campaign";
  if (!foreign.empty()) return "contains run " + foreign + ", which is not of its campaign";
  return "lacks " + std::to_string(planned - present) + " of " + count_text(planned, "run") +
         " of its campaign, " + first_missing + " first";
}

PlanComparison compare_plan(const ResultFile& file, const CampaignConfig& config) {
  PlanComparison plan;
  const Manifest manifest = file.read_manifest();
  const std::vector<std::string> hashes = hashes_of(file);
  const int repetitions = config.options.repetitions;
  plan.planned = hashes.size() * config.methods.size() * static_cast<std::size_t>(repetitions);
  if (manifest.count("until") == 0) {
    RunPlan stated = plan_of(manifest, file.path());
    if (stated.shard.count > 1) plan.shard = to_string(stated.shard);
    stated.runs_of_each = config.methods.size() * static_cast<std::size_t>(repetitions);
    plan.planned = stated.runs_of(stated.shard);
    if (plan.planned > hashes.size() * stated.runs_of_each)
      plan.first_missing = "those of a scenario";
  }
  std::set<std::string> methods;
  for (const NamedMethod& method : config.methods) methods.insert(method.name);
  std::set<std::tuple<std::string, std::string, int>> found;
  file.for_each_key(
      [&](const std::string& hash, const std::string& method, int repetition, const std::string&) {
        if (methods.count(method) == 0 || repetition < 0 || repetition >= repetitions)
          plan.foreign = run_id(run_of(hash, method, repetition));
        found.emplace(hash, method, repetition);
      });
  plan.present = found.size();
  for (const std::string& hash : hashes)
    for (const std::string& method : methods)
      for (int repetition = 0; repetition < repetitions; ++repetition)
        if (plan.first_missing.empty() && found.count({hash, method, repetition}) == 0)
          plan.first_missing = "run " + run_id(run_of(hash, method, repetition));
  return plan;
}

std::vector<std::string> statement_differences(const ResultFile& file, const CampaignConfig& config,
                                               const IniFile& ini) {
  const auto is_compared = [](const std::string& key) {
    return !starts_with(key, "version.") && !starts_with(key, "scenarios.") &&
           !starts_with(key, "until") && !starts_with(key, kKeptPrefix) && !is_method_file(key);
  };
  const Manifest recorded = file.read_manifest();
  Manifest here = make_manifest(config, {}, std::nullopt);
  std::vector<std::string> differences;
  const auto parts = identity_parts(here), stated = identity_parts(recorded);
  // An option that another version of Slalom does not have is stated by one of them only.
  const auto is_stated = [&](const std::string& key) {
    const std::size_t dot = key.rfind('.');
    return parts.count(key) > 0 &&
           (stated.count(key) > 0 ||
            (dot != std::string::npos && ini.get(key.substr(0, dot), key.substr(dot + 1))));
  };
  for (const IdentityDifference& difference : identity_differences(here, recorded))
    if (is_compared(difference.key) && is_stated(difference.key) &&
        !differs_in_folders(difference, recorded))
      differences.push_back(difference_text(difference));
  for (const char* key : {kPrivilegedKey, kKnownMapKey, "seed", "campaign"}) {
    const auto found = recorded.find(key);
    const std::string text = found == recorded.end() ? "" : found->second;
    if (text != here[key]) differences.push_back(difference_text({key, here[key], text}));
  }
  return differences;
}

ScenarioSet compare_scenarios(const ResultFile& file, const CampaignConfig& config, int jobs,
                              Progress& progress) {
  const std::vector<std::string> hashes = hashes_of(file);
  const std::string hash = content_hash(hashes), testbed = testbed_of(hash);
  ScenarioSet set;
  set.text = count_text(hashes.size(), "scenario") + " of hash " + hash +
             (testbed.empty() ? "" : ", those of " + testbed);
  ScenarioSources sources = config.sources;
  if (!sources.section.list.empty() || !sources.section.maps.empty()) return set;
  sources.context.jobs = jobs;
  std::vector<Scenario> made = collect_scenarios(sources, load_occupancy_grid, progress);
  const Manifest manifest = file.read_manifest();
  const auto quick = manifest.find("quick");
  const bool sampled = quick != manifest.end();
  const std::string maker = sampled ? "--quick chooses" : "the campaign generates";
  if (sampled) {
    const std::string problem = choose_again(quick->second, config, jobs, progress, made);
    if (!problem.empty()) {
      set.differences.push_back("its manifest states quick = " + quick->second + "; " + problem);
      return set;
    }
  }
  Manifest recorded = manifest, here = make_manifest(config, made, std::nullopt);
  for (const char* key : {"scenarios.hash", "scenarios.names"})
    if (recorded[key] != here[key])
      set.differences.push_back(difference_text({key, here[key], recorded[key]}));
  if (const auto shard = manifest.find(kShardKey);
      shard != manifest.end() && !shard->second.empty())
    made = scenarios_of_shard(std::move(made), parse_shard(shard->second, file.path()));
  std::set<std::string> expected;
  for (const Scenario& scenario : made) expected.insert(scenario.hash());
  const auto others = static_cast<std::size_t>(
      std::count_if(hashes.begin(), hashes.end(),
                    [&](const std::string& one) { return expected.count(one) == 0; }));
  if (others == 0 && manifest.count("until") == 0 && expected.size() != hashes.size())
    set.differences.push_back("the file has " + count_text(hashes.size(), "scenario") + ", " +
                              maker + " " + std::to_string(expected.size()));
  if (others > 0)
    set.differences.push_back(count_text(others, "scenario") + " of " +
                              std::to_string(hashes.size()) + " are not those that " + maker);
  if (set.differences.empty())
    set.text += sampled ? ", generated and chosen again" : ", generated again";
  set.made = std::move(made);
  return set;
}

std::string compare_stop(const ResultFile& file, const Campaign& campaign,
                         const std::vector<Scenario>& pool, const Execution& execution) {
  const ScratchFolder folder;
  Manifest manifest = file.read_manifest();
  ResultFile copy = ResultFile::create(folder.path() + "/runs.results", manifest,
                                       file.descriptors(), file.metrics());
  std::size_t runs = 0;
  for (const auto& [hash, name] : file.read_scenario_names()) {
    copy.add_scenario(file.read_record(hash), file.read_scenario(hash), file.read_references(hash));
    for (const RunRecord& run : file.read_runs(hash)) {
      copy.add_run(run, {}, PackedTrajectory());
      ++runs;
    }
  }
  copy.commit();
  long long max_runs = 0;
  double confidence = 0;
  parse_integer(manifest["until.max_runs"], max_runs);
  if (!parse_number(manifest["until.confidence"], confidence) || max_runs < 0)
    return "its manifest states until without until.confidence or until.max_runs";
  const StoppingRule rule = parse_stopping_rule(
      manifest["until"], static_cast<std::size_t>(max_runs), campaign.options, campaign.methods);
  CampaignRecorder recorder(campaign, std::move(copy));
  const SequentialReport report = run_until(recorder, rule, pool, confidence, execution);
  if (!report.complete || report.runs == runs) return "";
  return "its manifest states until = " + rule.text + ", which stops after " +
         count_text(report.runs, "run") + "; the file has " + std::to_string(runs);
}

}  // namespace slalom
