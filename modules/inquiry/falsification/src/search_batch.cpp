// SPDX-License-Identifier: BSD-3-Clause
#include "search_batch.h"

#include <slalom/core/byte_stream.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr char kBatchLog[] = "log of a batch";

}  // namespace

BatchRunner::BatchRunner(const FalsificationSetup& setup, const SearchOptions& options)
    : setup_(setup),
      options_(options),
      mix_(setup.run.robot),
      methods_(setup),
      hunt_(setup, options, mix_, methods_) {}

bool BatchRunner::is_failure(Outcome outcome) const {
  return std::find(options_.outcomes.begin(), options_.outcomes.end(), outcome) !=
         options_.outcomes.end();
}

std::unique_ptr<World> BatchRunner::draw(SearchStrategy strategy, std::uint64_t index,
                                         SharedTaskLog& log) {
  if (strategy == SearchStrategy::Adaptive)
    if (auto world = draw_adaptive(index, log)) return world;
  const std::uint64_t seed = derive_seed(options_.seed, to_string(strategy));
  return draw_fair_world(mix_, setup_, options_.fairness, seed, index);
}

std::unique_ptr<World> BatchRunner::draw_adaptive(std::uint64_t index, SharedTaskLog& log) {
  if (options_.probe) return hunt_.draw(index, [&] { log.heartbeat(); });
  if (setup_.surrogate) return draw_of_surrogate(index, log);
  return parents_->empty() ? nullptr : draw_changed(index);
}

/// The first of some random scenarios in which the surrogate fails.
std::unique_ptr<World> BatchRunner::draw_of_surrogate(std::uint64_t index, SharedTaskLog& log) {
  constexpr std::uint64_t kWorlds = 200;
  const std::uint64_t seed = derive_seed(options_.seed, "surrogate", index);
  for (std::uint64_t i = 0; i < kWorlds; ++i) {
    log.heartbeat();
    auto world = draw_fair_world(mix_, setup_, options_.fairness, seed, i);
    if (is_failure(methods_.run(*world, setup_.surrogate_index()).outcome)) return world;
  }
  return nullptr;
}

/// None if the changes do not give a fair scenario.
std::unique_ptr<World> BatchRunner::draw_changed(std::uint64_t index) const {
  constexpr int kMaxAttempts = 20;
  RandomEngine engine(derive_seed(options_.seed, "changed", index));
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    const int last = static_cast<int>(parents_->size()) - 1;
    const auto& parent = (*parents_)[static_cast<std::size_t>(uniform_int(engine, 0, last))];
    if (auto world = draw_changed_world(parent.scenario, setup_, options_.fairness, engine))
      return world;
  }
  return nullptr;
}

bool BatchRunner::has_witness(const World& world) {
  for (const std::size_t i : setup_.witnesses_in(world.scenario()))
    if (methods_.run(world, i).outcome == Outcome::Success) return true;
  return false;
}

void BatchRunner::execute(const SearchBatch& batch, SharedTaskLog& log, SharedTaskLog& begun) {
  hunt_.reset();
  for (std::uint64_t index = batch.begin; index < batch.end; ++index) {
    begun.heartbeat();
    run(batch.strategy, index, log);
  }
}

bool BatchRunner::run(SearchStrategy strategy, std::uint64_t index, SharedTaskLog& log) {
  const auto append = [&](ByteWriter& entry) {
    const std::string bytes = ByteWriter().text(entry.take()).take();
    log.append(bytes.data(), bytes.size());
  };
  const auto world = draw(strategy, index, log);
  log.heartbeat();
  append(ByteWriter().u64(index).text(serialize(world->scenario())));
  const Trial trial = methods_.run(*world, 0);
  log.heartbeat();
  const bool witnessed = is_failure(trial.outcome) && has_witness(*world);
  append(ByteWriter().u8(witnessed ? 1 : 0).text(to_bytes(trial)));
  if (strategy == SearchStrategy::Adaptive && options_.probe) {
    if (witnessed)
      hunt_.succeed();
    else
      hunt_.report(world->scenario(), trial, methods_.run(*world, 1));
  }
  return witnessed;
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
