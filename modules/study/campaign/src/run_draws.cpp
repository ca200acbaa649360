// SPDX-License-Identifier: BSD-3-Clause
#include "run_executor.h"

#include <slalom/campaign/measure.h>
#include <slalom/campaign/method_pool.h>
#include <slalom/campaign/run_draws.h>
#include <slalom/core/byte_stream.h>
#include <slalom/core/error.h>
#include <slalom/workers/worker_pool.h>

namespace slalom {
namespace {

constexpr char kAnswer[] = "a run in a worker process";

CampaignOptions without_measurements(CampaignOptions options, const std::string& metric) {
  options.metrics.clear();
  if (!metric.empty()) options.metrics = {metric};
  options.descriptors.clear();
  options.record = {};
  options.record.trajectories = StoredTrajectories::None;
  options.record.repeated_runs = 0;
  return options;
}

/// Draws runs and executes them; each worker process has a copy of its own.
class DrawExecutor {
 public:
  DrawExecutor(const NamedMethod& method, const CampaignOptions& options, const DrawRun& draw,
               const std::string& metric)
      : draw_(draw), metric_(metric) {
    campaign_.options = without_measurements(options, metric);
    campaign_.methods = {method};
  }

  DrawnRun execute(std::size_t index, SharedTaskLog& log) {
    std::optional<RunDraw> drawn = draw_(index);
    if (!drawn)
      return {Outcome::UnsolvableScenario, "no scenario that the robot can solve", "", "", {}};
    if (drawn->options) {
      executor_.reset();
      campaign_.options = without_measurements(std::move(*drawn->options), metric_);
    }
    // Two slots, since the executor keeps the world of the last scenario by its index.
    slot_ = 1 - slot_;
    while (campaign_.scenarios.size() < 2) campaign_.scenarios.push_back(drawn->scenario);
    campaign_.scenarios[slot_] = std::move(drawn->scenario);
    const Scenario& scenario = campaign_.scenarios[slot_];
    if (!executor_) executor_.emplace(campaign_, references_, true);
    const World& world = executor_->world(slot_);
    references_[slot_] = find_earliest(campaign_.options, world);
    if (const std::string lack = lack_of_time(campaign_.options, world, references_[slot_]);
        !lack.empty())
      return {Outcome::UnsolvableScenario,
              "scenario " + scenario.name() + ": " + lack,
              "",
              "",
              {},
              0,
              true};
    const std::string& hash = scenario.hash();
    const RunFindings findings = executor_->execute(
        {slot_, campaign_.methods[0].name, 0, run_seed(campaign_.options.seed, hash, 0)}, log);
    const RunRecord& run = findings.record;
    const auto& figures = findings.timing.values;
    const auto cycle = figures.find("cycle_time_p99");
    const auto metric = run.metrics.find(metric_);
    std::optional<double> value;
    if (metric != run.metrics.end() && !metric->second.value.is_na())
      value = metric->second.value.number();
    return {from_name<Outcome>(run.outcome).value(),
            run.outcome_detail,
            hash,
            run.trajectory_hash,
            value,
            cycle == figures.end() ? 0 : cycle->second};
  }

  void destroy_methods() {
    if (executor_) executor_->destroy_methods();
  }

 private:
  const DrawRun& draw_;
  const std::string& metric_;
  Campaign campaign_;
  std::vector<References> references_ = std::vector<References>(2);
  std::optional<RunExecutor> executor_;
  std::size_t slot_ = 0;
};

std::string to_bytes(const DrawnRun& run) {
  return ByteWriter()
      .u8(static_cast<std::uint8_t>(run.outcome))
      .text(run.detail)
      .text(run.scenario_hash)
      .text(run.trajectory_hash)
      .u8(run.value ? 1 : 0)
      .f64(run.value.value_or(0))
      .f64(run.cycle_time)
      .u8(run.lacks_time ? 1 : 0)
      .take();
}

/// Nullopt for an answer of a damaged process.
std::optional<DrawnRun> read_answer(const std::string& bytes) {
  try {
    ByteReader reader(bytes, kAnswer);
    DrawnRun run;
    run.outcome = static_cast<Outcome>(reader.u8());
    if (run.outcome > Outcome::InfrastructureError) return std::nullopt;
    run.detail = reader.text();
    run.scenario_hash = reader.text();
    run.trajectory_hash = reader.text();
    const bool has_value = reader.u8() == 1;
    const double value = reader.f64();
    if (has_value) run.value = value;
    run.cycle_time = reader.f64();
    run.lacks_time = reader.u8() == 1;
    return run;
  } catch (const Error&) {
    return std::nullopt;
  }
}

DrawnRun run_of(const WorkResult& result) {
  if (result.status == WorkResult::Status::Done) return read_answer(result.payload).value();
  return {outcome_of(result), result.detail, "", "", {}};
}

}  // namespace

bool run_draws(const NamedMethod& method, const CampaignOptions& options, const DrawRun& draw,
               std::size_t max_runs, const DrawExecution& execution,
               const std::function<bool(const DrawnRun&)>& receive) {
  DrawExecutor executor(method, options, draw, execution.metric);
  bool finished = false;
  PoolOptions pool = pool_of_runs(options, execution.workers);
  pool.hooks.is_valid = [](std::size_t, const std::string& payload) {
    return read_answer(payload).has_value();
  };
  pool.hooks.at_end = [&] { executor.destroy_methods(); };
  const WorkItem item = [&](std::size_t index, SharedTaskLog& log) {
    return to_bytes(executor.execute(index, log));
  };
  const auto pass_on = [&](std::size_t, WorkResult&& result) {
    if (finished) return;
    const DrawnRun run = run_of(result);
    if (run.lacks_time) throw usage_error("[simulation] max_time", run.detail, "more, or auto");
    if (run.outcome == Outcome::InfrastructureError)
      throw job_error("a run of " + method.name, run.detail);
    finished = !receive(run);
  };
  const bool complete = run_in_workers(max_runs, pool, item, pass_on, [&] {
    return finished || (execution.interrupted && execution.interrupted());
  });
  return complete || finished;
}

}  // namespace slalom
