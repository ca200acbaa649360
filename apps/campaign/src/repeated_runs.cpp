// SPDX-License-Identifier: BSD-3-Clause
#include "repeated_runs.h"

#include <slalom/core/hash.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

struct Field {
  const char *name, *unit;
};
/// In the order of Sample::numbers().
constexpr Field kFields[Sample::kNumbers] = {{"time", "s"},
                                             {"x", "m"},
                                             {"y", "m"},
                                             {"heading", "rad"},
                                             {"v", "m/s"},
                                             {"w", "rad/s"},
                                             {"command v", "m/s"},
                                             {"command w", "rad/s"},
                                             {"lateral v", "m/s"},
                                             {"command vy", "m/s"},
                                             {"distance driven", "m"}};

/// Executes selected runs and keeps them.
class RepeatingSink : public CampaignSink {
 public:
  RepeatingSink(const std::set<RunKey>& runs, const ResultFile* file) : runs_(runs), file_(file) {}

  std::optional<References> known_references(const Scenario& scenario) override {
    if (file_ == nullptr) return std::nullopt;
    return file_->read_references(scenario.hash());
  }
  bool has_run(const Scenario& scenario, const RunSpec& spec) override {
    return runs_.count({scenario.hash(), spec.method, spec.repetition}) == 0;
  }
  void add_scenario(const ScenarioRecord&, const References&, const PackedScenario&) override {}
  void add_run(const RunRecord& run, const RunTiming&,
               const PackedTrajectory& trajectory) override {
    if (run.outcome != to_string(Outcome::MethodDeadline) &&
        run.outcome != to_string(Outcome::InfrastructureError))
      executed[key_of(run)] = {run, trajectory};
  }

  std::map<RunKey, ExecutedRun> executed;

 private:
  const std::set<RunKey>& runs_;
  const ResultFile* file_;
};

std::string trajectory_difference(const Trajectory& before, const Trajectory& now) {
  const auto after = [](double t) { return "differs after " + format_fixed(t, 2) + " s: "; };
  const std::size_t common = std::min(before.samples.size(), now.samples.size());
  for (std::size_t i = 0; i < common; ++i) {
    const auto a = before.samples[i].numbers(), b = now.samples[i].numbers();
    for (std::size_t j = 0; j < a.size(); ++j)
      if (!same_bits(a[j], b[j]))
        return after(before.samples[i].t) + kFields[j].name + " " + format_number(a[j]) + " and " +
               format_number(b[j]) + " " + kFields[j].unit;
  }
  const auto& longer = before.samples.size() > common ? before : now;
  if (common == 0 || longer.samples.size() == common) return "";
  return after(longer.samples[common - 1].t) + "one execution ends there, the other after " +
         format_fixed(longer.duration(), 2) + " s";
}

}  // namespace

RunKey key_of(const RunRecord& run) {
  return {run.scenario_hash, run.method, run.repetition};
}

RepeatedRuns execute_again(Campaign campaign, const std::set<RunKey>& runs, const ResultFile* file,
                           Execution execution) {
  RepeatingSink sink(runs, file);
  execution.process_per_run = true;
  std::set<std::string> hashes;
  for (const auto& [hash, method, repetition] : runs) hashes.insert(hash);
  auto& scenarios = campaign.scenarios;
  scenarios.erase(
      std::remove_if(scenarios.begin(), scenarios.end(),
                     [&](const Scenario& scenario) { return hashes.count(scenario.hash()) == 0; }),
      scenarios.end());
  campaign.options.repetitions = 1;
  for (const auto& [hash, method, repetition] : runs)
    campaign.options.repetitions = std::max(campaign.options.repetitions, repetition + 1);
  const bool complete = run_campaign(campaign, sink, execution).complete;
  return {complete, std::move(sink.executed)};
}

std::string execution_difference(const RunRecord& before, const Trajectory* trajectory,
                                 const ExecutedRun& again) {
  const ScenarioRecord scenario{before.scenario_hash, before.scenario_name, {}};
  const std::string values =
      line_difference(dump_line("", scenario, before), dump_line("", scenario, again.record));
  if (values.empty()) return "";
  if (trajectory != nullptr && before.trajectory_hash != again.record.trajectory_hash) {
    const std::string difference =
        trajectory_difference(*trajectory, again.trajectory.unpack(run_id(before)));
    if (!difference.empty()) return difference;
  }
  return "differs: " + values;
}

}  // namespace slalom
