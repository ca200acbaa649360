// SPDX-License-Identifier: BSD-3-Clause
#include "solvable.h"

#include <slalom/core/parallel.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>

namespace slalom {
namespace {

/// Scenarios of a round: large enough to keep all threads busy, small enough for memory.
constexpr int kRound = 128;
constexpr double kPartSeconds = 1;

constexpr const char* kOtherMix = "the state of another mix of generators";

/// Thread-safe progress within a part, so that slow parts report progress and can be canceled.
class PartProgress {
 public:
  PartProgress(Progress& progress, int done) : progress_(progress), done_(done) {}
  void item_done() {
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_.advance(static_cast<std::size_t>(++done_));
  }

 private:
  Progress& progress_;
  std::mutex mutex_;
  int done_;
};

std::vector<double> weights_of(const std::vector<WeightedGenerator>& mix) {
  std::vector<double> weights;
  for (const WeightedGenerator& entry : mix) weights.push_back(entry.weight);
  return weights;
}

}  // namespace

WeightedRoundRobin::WeightedRoundRobin(std::vector<double> weights)
    : weights_(std::move(weights)), counts_(weights_.size(), 0) {
  for (const double weight : weights_) total_weight_ += weight;
}

WeightedRoundRobin::Slot WeightedRoundRobin::next() {
  double slots = 1;
  for (const int count : counts_) slots += count;
  std::size_t most_underserved = 0;
  double max_deficit = -1;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const double deficit = slots * weights_[i] / total_weight_ - counts_[i];
    if (deficit <= max_deficit) continue;
    max_deficit = deficit;
    most_underserved = i;
  }
  return {most_underserved, counts_[most_underserved]++};
}

struct MixStream::Impl {
  Impl(std::vector<WeightedGenerator> generators, MixSettings mix_settings, MixState start,
       WallClock wall_clock)
      : mix(std::move(generators)),
        settings(std::move(mix_settings)),
        state(std::move(start)),
        clock(std::move(wall_clock)),
        schedule(weights_of(mix)),
        search(settings.each) {
    expect_valid(state.round);
    expect_valid(state.redraws);
    if (state.begun > settings.each.count) throw std::invalid_argument(kOtherMix);
    for (int i = 0; i < state.begun; ++i) schedule.next();
  }

  std::vector<WeightedGenerator> mix;
  MixSettings settings;
  MixState state;
  WallClock clock;
  WeightedRoundRobin schedule;
  SolvableSearch search;
  std::vector<MixDraw> part;  ///< with the successful attempts

  /// Stores the number of the successful attempt in `draw`.
  GeneratedScenario make(MixDraw& draw) const {
    const WeightedGenerator& entry = mix[draw.generator];
    const std::string name = scenario_name(entry.name_prefix, draw.index);
    const auto candidate = [&](int attempt, std::string&) {
      RandomEngine engine(seed_of(draw, attempt));
      return std::make_optional(
          with_goal_heading(to_representation(entry.generator->generate(name, engine)),
                            settings.each, seed_of(draw, attempt)));
    };
    const SolvableWorld found = search.find(name, candidate, draw.attempt);
    draw.attempt = found.attempt;
    const std::uint64_t seed = seed_of(draw, found.attempt);
    if (settings.walkers.count > 0 || settings.people.count > 0)
      return populated(*found.world, entry.generator->name(), seed);
    return described(*found.world, entry.generator->name(), seed);
  }

  GeneratedScenario described(const World& world, const std::string& generator,
                              std::uint64_t seed) const {
    GeneratedScenario generated{world.scenario(), generator, seed};
    if (settings.describe) generated.values = settings.describe(world);
    return generated;
  }

  /// Adds walkers and people, each from a random stream of their own, so that the static obstacles
  /// are those of the same mix without them.
  GeneratedScenario populated(const World& world, const std::string& generator,
                              std::uint64_t seed) const {
    RandomEngine walkers(derive_seed(seed, "walkers")), people(derive_seed(seed, "people"));
    const double radius = settings.each.robot_radius;
    Scenario scenario = with_walkers(world, radius, settings.walkers, walkers);
    if (settings.people.count > 0)
      scenario = scenario.with_people(sample_people(world, radius, settings.people, people));
    return described(World(std::move(scenario), settings.each.resolution), generator, seed);
  }

  std::uint64_t seed_of(const MixDraw& draw, int attempt) const {
    const WeightedGenerator& entry = mix[draw.generator];
    const std::uint64_t scenario_seed = derive_seed(
        entry.seed, "scenario/" + entry.generator->name(), static_cast<std::uint64_t>(draw.index));
    return derive_seed(scenario_seed, "attempt", static_cast<std::uint64_t>(attempt));
  }

  Scenario to_representation(Scenario scenario) const {
    if (!settings.representation) return scenario;
    return convert(scenario, *settings.representation, settings.conversion_resolution);
  }

  void expect_valid(const std::vector<MixDraw>& draws) const {
    for (const MixDraw& draw : draws)
      if (draw.generator >= mix.size()) throw std::invalid_argument(kOtherMix);
  }

  void begin_round() {
    state.round.swap(state.redraws);
    if (!state.round.empty()) return;
    for (int i = std::min(kRound, settings.each.count - state.begun); i > 0; --i, ++state.begun) {
      const WeightedRoundRobin::Slot slot = schedule.next();
      state.round.push_back({slot.generator, slot.index, 0});
    }
  }
};

MixStream::MixStream(std::vector<WeightedGenerator> mix, MixSettings settings, MixState state,
                     WallClock clock)
    : impl_(std::make_unique<Impl>(std::move(mix), std::move(settings), std::move(state),
                                   std::move(clock))) {}
MixStream::~MixStream() = default;
MixStream::MixStream(MixStream&&) noexcept = default;

bool MixStream::finished() const {
  return impl_->state.done() >= impl_->settings.each.count;
}

std::vector<GeneratedScenario> MixStream::next(Progress& progress) {
  if (impl_->state.round.empty()) impl_->begin_round();
  PartProgress part_progress(progress, impl_->state.done());
  const double end = impl_->clock() + kPartSeconds;
  impl_->part = impl_->state.round;
  std::vector<std::optional<GeneratedScenario>> made(impl_->part.size());
  parallel_for(made.size(), impl_->settings.jobs, [&](std::size_t i) {
    if (i > 0 && impl_->clock() >= end) return;
    made[i].emplace(impl_->make(impl_->part[i]));
    part_progress.item_done();
  });
  std::vector<GeneratedScenario> part;
  for (std::size_t i = 0; i < made.size() && made[i]; ++i) part.push_back(std::move(*made[i]));
  impl_->part.resize(part.size());
  return part;
}

void MixStream::commit_part(const std::vector<std::size_t>& duplicates) {
  MixState& state = impl_->state;
  for (const std::size_t i : duplicates) {
    state.redraws.push_back(impl_->part[i]);
    ++state.redraws.back().attempt;
  }
  state.round.erase(state.round.begin(),
                    state.round.begin() + static_cast<std::ptrdiff_t>(impl_->part.size()));
  impl_->part.clear();
}

const MixState& MixStream::state() const {
  return impl_->state;
}

int MixStream::count() const {
  return impl_->settings.each.count;
}

void generate_mix(const std::vector<WeightedGenerator>& mix, const MixSettings& settings,
                  Progress& progress, const GenerationSink& sink) {
  MixStream stream(mix, settings);
  progress.start("Generating scenarios", static_cast<std::size_t>(settings.each.count));
  while (!stream.finished()) {
    std::vector<GeneratedScenario> part = stream.next(progress);
    stream.commit_part(sink(part));
    progress.advance(static_cast<std::size_t>(stream.state().done()));
  }
  progress.finish();
}

std::vector<std::size_t> DistinctScenarios::add(std::vector<GeneratedScenario>& batch) {
  std::vector<std::size_t> duplicates;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (hashes_.insert(batch[i].scenario.hash()).second) {
      scenarios_.push_back(std::move(batch[i].scenario));
    } else {
      duplicates.push_back(i);
    }
  }
  return duplicates;
}

}  // namespace slalom
