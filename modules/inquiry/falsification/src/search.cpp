// SPDX-License-Identifier: BSD-3-Clause
#include "search_batch.h"

#include <slalom/core/available_cores.h>
#include <slalom/core/error.h>
#include <slalom/io/scenario_list.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr std::uint64_t kBatch = 100;  // candidates
constexpr std::uint64_t kRound = 400;  // candidates of each strategy
constexpr std::size_t kMaxCloseCalls = 64;
constexpr std::size_t kOverSampling = 2;  // failures for each one that is searched

/// How many candidates of each strategy the rounds have. With a budget of time the first is small,
/// and the others so large that they take some seconds.
class RoundSizes {
 public:
  explicit RoundSizes(const SearchOptions& options)
      : options_(options), size_(options.minutes > 0 ? kFirst : kRound) {}

  std::uint64_t next(const SearchState& state) const {
    if (options_.runs == 0) return size_;
    return std::min<std::uint64_t>(size_, (options_.runs - state.runs() + 1) / 2);
  }
  void adapt(double seconds) {
    if (options_.minutes <= 0) return;
    if (seconds < kShort) size_ = std::min(2 * size_, kRound);
    if (seconds > kLong) size_ = std::max(size_ / 2, kFirst);
  }

 private:
  static constexpr std::uint64_t kFirst = 8;
  static constexpr double kShort = 2, kLong = 10;  // s
  const SearchOptions& options_;
  std::uint64_t size_;
};

SearchTally& tally_of(SearchState& state, SearchStrategy strategy) {
  return strategy == SearchStrategy::Random ? state.random : state.adaptive;
}

/// Executes the batches of one round.
class SearchRound {
 public:
  /// `candidates`: of each strategy.
  SearchRound(const FalsificationSetup& setup, const SearchOptions& options, SearchState& state,
              std::uint64_t candidates)
      : setup_(setup),
        options_(options),
        state_(state),
        candidates_(candidates),
        runner_(setup, options) {
    runner_.set_parents(state.near_misses);
  }

  /// False when interrupted; the state is then as before.
  bool execute() {
    for (const SearchStrategy strategy : enum_values<SearchStrategy>()) {
      const std::uint64_t begin = tally_of(state_, strategy).runs, end = begin + candidates_;
      for (std::uint64_t i = begin; i < end; i += kBatch)
        batches_.push_back({strategy, i, std::min(i + kBatch, end)});
    }
    while (!batches_.empty())
      if (!execute_batches()) return false;
    finish();
    return true;
  }

 private:
  struct Found {
    SearchStrategy strategy;
    CandidateRun run;
  };

  /// Also reports progress.
  bool interrupted() {
    if (options_.on_runs && begun_.heartbeats() > reported_)
      options_.on_runs(state_.runs() + (reported_ = begun_.heartbeats()));
    return options_.interrupted && options_.interrupted();
  }

  /// Batches whose process died continue after the run in which it did.
  bool execute_batches() {
    const std::vector<SearchBatch> batches = std::move(batches_);
    batches_.clear();
    const WorkItem item = [&](std::size_t i, SharedTaskLog& log) -> std::string {
      runner_.execute(batches[i], log, begun_);
      return log.contents();
    };
    const auto receive = [&](std::size_t i, WorkResult&& result) {
      const bool done = result.status == WorkResult::Status::Done;
      std::vector<CandidateRun> runs = read_batch_log(done ? result.payload : result.log);
      if (!done) continue_after_death(batches[i], runs, result);
      for (CandidateRun& run : runs) found_.push_back({batches[i].strategy, std::move(run)});
    };
    PoolOptions pool = pool_of_trials(setup_);
    pool.schedule.workers = worker_count(options_.workers);
    return run_in_workers(batches.size(), pool, item, receive, [this] { return interrupted(); });
  }

  void continue_after_death(const SearchBatch& batch, std::vector<CandidateRun>& runs,
                            const WorkResult& result) {
    const Trial dead = trial_of_dead_process(result);
    const bool is_probed = runs.empty() || runs.back().complete;
    if (is_probed) {
      if (!options_.probe && !setup_.surrogate)
        throw job_error("search", "a worker process died between two runs: " + result.detail);
      // A single step or a run of the surrogate has no scenario to keep.
      const std::uint64_t index = runs.empty() ? batch.begin : runs.back().index + 1;
      runs.emplace_back();
      runs.back().index = index;
    }
    CandidateRun& last = runs.back();
    last.trial = dead;
    last.witnessed = !is_probed && runner_.is_failure(dead.outcome) && has_witness_alone(last);
    if (last.index + 1 < batch.end) batches_.push_back({batch.strategy, last.index + 1, batch.end});
  }

  bool has_witness_alone(const CandidateRun& run) const {
    const Scenario scenario = scenario_of(run);
    for (const std::size_t i : setup_.witnesses_in(scenario))
      if (run_alone(setup_, scenario, i).outcome == Outcome::Success) return true;
    return false;
  }

  /// Adds the runs of the round to the state, in an order that does not depend on processes.
  void finish() {
    std::sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) {
      return std::make_pair(a.strategy, a.run.index) < std::make_pair(b.strategy, b.run.index);
    });
    for (const Found& found : found_) add(found.strategy, found.run);
    ++state_.rounds;
  }

  void add(SearchStrategy strategy, const CandidateRun& run) {
    SearchTally& tally = tally_of(state_, strategy);
    ++tally.runs;
    ++tally.outcomes[to_string(run.trial.outcome)];
    if (run.trial.outcome == Outcome::Success) {
      if (strategy == SearchStrategy::Random) add_near_miss(run);
    } else if (runner_.is_failure(run.trial.outcome)) {
      const bool counts = !run.scenario.empty() && (run.witnessed || is_own(run));
      ++(counts ? tally.failures : tally.without_witness);
      if (counts && state_.failures.size() < kOverSampling * options_.max_failures)
        state_.failures.push_back({strategy, run.index, scenario_of(run), run.trial});
    }
  }

  static Scenario scenario_of(const CandidateRun& run) {
    return deserialize_scenario(run.scenario, "search");
  }

  bool is_own(const CandidateRun& run) const {
    return !needs_witness(options_.fairness, scenario_of(run), run.trial.outcome);
  }

  void add_near_miss(const CandidateRun& run) {
    auto& calls = state_.near_misses;
    if (calls.size() >= kMaxCloseCalls && run.trial.clearance >= calls.back().clearance) return;
    calls.push_back({scenario_of(run), run.trial.clearance});
    std::stable_sort(calls.begin(), calls.end(),
                     [](const auto& a, const auto& b) { return a.clearance < b.clearance; });
    if (calls.size() > kMaxCloseCalls) calls.pop_back();
  }

  const FalsificationSetup& setup_;
  const SearchOptions& options_;
  SearchState& state_;
  std::uint64_t candidates_;
  BatchRunner runner_;
  SharedTaskLog begun_{0};  ///< a heartbeat for each run
  std::size_t reported_ = 0;
  std::vector<SearchBatch> batches_;
  std::vector<Found> found_;
};

std::string limit_reached(const SearchState& state, const SearchOptions& options, double began) {
  if (state.failures.size() >= options.max_failures)
    return std::to_string(state.failures.size()) + " failures were found";
  if (options.runs > 0 && state.runs() >= options.runs)
    return "run budget exhausted after " + std::to_string(state.runs()) + " runs";
  if (options.minutes > 0 && steady_seconds() - began >= 60 * options.minutes)
    return "time budget exhausted";
  return "";
}

}  // namespace

std::vector<Outcome> severe_outcomes() {
  return {Outcome::Collision,      Outcome::LeftWorkspace,        Outcome::MethodCrash,
          Outcome::MethodDeadline, Outcome::MethodInvalidCommand, Outcome::MethodError};
}

SearchResult search(const FalsificationSetup& setup, const SearchOptions& options) {
  if (options.runs == 0 && options.minutes <= 0)
    throw usage_error("search", "no budget", "a number of runs or of minutes");
  if (options.probe && setup.witnesses.empty())
    throw usage_error("search", "no reference to compare single steps with", "a witness");
  const double began = steady_seconds();
  SearchResult result;
  result.state = options.known;
  RoundSizes sizes(options);
  while ((result.stopped = limit_reached(result.state, options, began)).empty()) {
    const double round_began = steady_seconds();
    SearchRound round(setup, options, result.state, sizes.next(result.state));
    if (!round.execute()) {
      result.stopped = "interrupted";
      return result;
    }
    sizes.adapt(steady_seconds() - round_began);
    if (options.save) options.save(result.state);
  }
  result.complete = true;
  return result;
}

}  // namespace slalom
