// SPDX-License-Identifier: BSD-3-Clause
#include "repeated_runs.h"

#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/app/repeatability.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/results/repeatability.h>

#include <iostream>

namespace slalom {
namespace {

/// Whether the outcome is one of the method, which it would have again.
bool can_be_repeated(const std::string& outcome) {
  return outcome != to_string(Outcome::InfrastructureError) &&
         outcome != to_string(Outcome::MethodDeadline) &&
         outcome != to_string(Outcome::UnsolvableScenario);
}

/// The runs to execute, without those that the manifest knows.
std::set<RunKey> choose_runs(const ResultFile& file, const Manifest& manifest,
                             const CampaignConfig& config) {
  std::map<std::string, std::size_t> missing;
  auto measured = repeatability_of(manifest);
  const auto wanted = static_cast<std::size_t>(config.options.record.repeated_runs);
  for (const NamedMethod& method : config.methods)
    if (!mixes_versions(manifest, method.name) && measured[method.name].repeated < wanted)
      missing[method.name] = wanted - measured[method.name].repeated;
  if (missing.empty()) return {};
  std::map<std::string, std::set<std::pair<int, std::string>>> first;
  file.for_each_key([&](const std::string& hash, const std::string& method, int repetition,
                        const std::string& outcome) {
    if (missing.count(method) == 0 || !can_be_repeated(outcome)) return;
    RunRecord run;
    run.scenario_hash = hash;
    run.method = method;
    run.repetition = repetition;
    if (manifest.count(kRepeatedPrefix + run_id(run)) > 0) return;
    auto& runs = first[method];
    runs.emplace(repetition, hash);
    if (runs.size() > missing[method]) runs.erase(std::prev(runs.end()));
  });
  std::set<RunKey> chosen;
  for (const auto& [method, runs] : first)
    for (const auto& [repetition, hash] : runs) chosen.emplace(hash, method, repetition);
  return chosen;
}

/// Executes the runs and stores in the manifest what differs.
void compare_again(const CampaignConfig& config, const CampaignArguments& arguments,
                   const std::set<RunKey>& chosen, const ResultFile& file, Manifest& manifest) {
  Campaign campaign{config.options, {}, config.methods};
  std::set<std::string> hashes;
  for (const auto& [hash, method, repetition] : chosen)
    if (hashes.insert(hash).second) campaign.scenarios.push_back(file.read_scenario(hash));
  const auto progress = make_terminal_progress(arguments.quiet);
  const InterruptGuard guard;
  const RepeatedRuns again =
      execute_again(campaign, chosen, &file,
                    {campaign_workers(config, arguments), *progress, InterruptGuard::raised});
  if (!again.complete)
    throw Interrupted("the runs are kept in " + file.path() + "; the same command continues");
  const bool stored = config.options.record.trajectories == StoredTrajectories::All;
  for (const auto& [key, run] : again.runs) {
    const auto before = file.read_run(std::get<0>(key), std::get<1>(key), std::get<2>(key));
    const Trajectory trajectory = stored ? file.read_trajectory(*before) : Trajectory();
    manifest[kRepeatedPrefix + run_id(run.record)] =
        execution_difference(*before, stored ? &trajectory : nullptr, run);
  }
}

void print_repeatability(const CampaignConfig& config, const Manifest& manifest, bool quiet) {
  auto measured = repeatability_of(manifest);
  std::map<std::string, std::vector<std::string>> repeatable;  // methods by text
  for (const NamedMethod& method : config.methods) {
    const auto found = measured.find(method.name);
    if (found == measured.end()) continue;
    if (found->second.is_repeatable())
      repeatable[to_string(found->second)].push_back(method.name);
    else
      print_notice(method.name + ": " + to_string(found->second));
  }
  for (const auto& [text, methods] : repeatable)
    if (!quiet) print_notice(join(methods, ", ") + ": " + text);
}

}  // namespace

void measure_repeatability(const CampaignConfig& config, const CampaignArguments& arguments,
                           const std::string& results_path) {
  ResultFile file = ResultFile::open(results_path);
  Manifest manifest = file.read_manifest();
  const std::set<RunKey> chosen = choose_runs(file, manifest, config);
  if (!chosen.empty()) {
    compare_again(config, arguments, chosen, file, manifest);
    file.replace_manifest(manifest);
    if (!file.commit()) throw job_error(results_path, "is being read by another program");
  }
  print_repeatability(config, manifest, arguments.quiet);
}

}  // namespace slalom
