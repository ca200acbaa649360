#include "search_batch.h"

#include <slalom/core/byte_stream.h>
#include <slalom/core/text.h>
#include <slalom/generation/mutation.h>
#include <slalom/io/scenario_list.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr char kBatchLog[] = "log of a batch";

/// Of obstacles and of the task; those that change much, or the workspace, lead away from the
/// parent.
constexpr std::array kMutations = {Mutation::Move,      Mutation::Resize, Mutation::Remove,
                                   Mutation::Duplicate, Mutation::Add,    Mutation::MoveStartGoal};

std::optional<Scenario> changed(const Scenario& parent, const TestBench& bench,
                                RandomEngine& engine) {
  MutationLimits limits;
  limits.robot_radius = bench.setup.robot.shape().enclosing_radius();
  limits.resolution = bench.setup.simulation.resolution;
  limits.min_distance = 4 * limits.robot_radius;
  const int which = uniform_int(engine, 0, static_cast<int>(kMutations.size()) - 1);
  return mutate(parent, kMutations[static_cast<std::size_t>(which)], limits, engine);
}

}  // namespace

BatchRunner::BatchRunner(const TestBench& bench, const SearchOptions& options)
    : bench_(bench), options_(options), mix_(bench.setup.robot), methods_(bench) {}

bool BatchRunner::is_failure(Outcome outcome) const {
  return std::find(options_.outcomes.begin(), options_.outcomes.end(), outcome) !=
         options_.outcomes.end();
}

std::unique_ptr<World> BatchRunner::draw(SearchHalf half, std::uint64_t index) {
  const std::string label = to_string(half);
  if (half == SearchHalf::Adaptive && options_.probe) {
    if (auto world = draw_probed(index)) return world;
  } else if (half == SearchHalf::Adaptive && !parents_->empty()) {
    if (auto world = draw_changed(index)) return world;
  }
  return draw_fair_world(mix_, bench_, options_.fairness, derive_seed(options_.seed, label), index);
}

/// None if the changes do not give a fair scenario.
std::unique_ptr<World> BatchRunner::draw_changed(std::uint64_t index) const {
  constexpr int kMaxAttempts = 20;
  RandomEngine engine(derive_seed(options_.seed, "changed", index));
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    const int last = static_cast<int>(parents_->size()) - 1;
    const auto& parent = (*parents_)[static_cast<std::size_t>(uniform_int(engine, 0, last))];
    const auto child = changed(parent.scenario, bench_, engine);
    if (!child) continue;
    auto world = std::make_unique<World>(*child, bench_.setup.simulation.resolution);
    if (judge_geometry(*world, bench_.setup.robot, options_.fairness).violation.empty())
      return world;
  }
  return nullptr;
}

/// Consecutive candidates approach the same difference. None if there is none in a few worlds, or
/// no fair start.
std::unique_ptr<World> BatchRunner::draw_probed(std::uint64_t index) {
  constexpr std::uint64_t kGroup = 10, kWorlds = 5;
  const std::uint64_t group = index / kGroup;
  if (!probed_ || probed_->first != group) {
    probed_.emplace(group, std::nullopt);
    const std::uint64_t seed = derive_seed(options_.seed, "probed", group);
    StepProbe probe(bench_, methods_);
    for (std::uint64_t i = 0; i < kWorlds && !probed_->second; ++i) {
      RandomEngine engine(derive_seed(seed, "poses", i));
      probed_->second =
          probe.find(draw_fair_world(mix_, bench_, options_.fairness, seed, i), engine);
    }
  }
  if (!probed_->second) return nullptr;
  RandomEngine engine(derive_seed(options_.seed, "approach", index));
  return approach(*probed_->second, bench_, options_.fairness, engine);
}

bool BatchRunner::has_witness(const World& world) {
  for (std::size_t i = 1; i <= bench_.witnesses.size(); ++i)
    if (methods_.run(world, i).outcome == Outcome::Success) return true;
  return false;
}

void BatchRunner::execute(const SearchBatch& batch, SharedTaskLog& log) {
  const auto append = [&](ByteWriter& entry) {
    const std::string bytes = ByteWriter().text(entry.take()).take();
    log.append(bytes.data(), bytes.size());
  };
  for (std::uint64_t index = batch.begin; index < batch.end; ++index) {
    const auto world = draw(batch.half, index);
    log.heartbeat();
    append(ByteWriter().u64(index).text(serialize(world->scenario())));
    const Trial trial = methods_.run(*world, 0);
    log.heartbeat();
    const bool witnessed = is_failure(trial.outcome) && has_witness(*world);
    append(ByteWriter().u8(witnessed ? 1 : 0).text(to_bytes(trial)));
  }
}

std::vector<CandidateRun> read_batch_log(const std::string& log) {
  std::vector<CandidateRun> runs;
  ByteReader entries(log, kBatchLog);
  for (std::size_t position = 0; position < log.size();) {
    const std::string entry = entries.text();
    position += sizeof(std::uint64_t) + entry.size();
    ByteReader reader(entry, kBatchLog);
    if (runs.empty() || runs.back().complete) {
      CandidateRun run;
      run.index = reader.u64();
      run.scenario = reader.text();
      runs.push_back(std::move(run));
    } else {
      runs.back().witnessed = reader.u8() != 0;
      runs.back().trial = trial_from_bytes(reader.text(), kBatchLog);
      runs.back().complete = true;
    }
  }
  return runs;
}

}  // namespace slalom
