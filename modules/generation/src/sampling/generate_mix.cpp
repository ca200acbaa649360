#include "solvable.h"

#include <slalom/core/parallel.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>
#include <mutex>

namespace slalom {
namespace {

/// Batch size: large enough to keep all threads busy, small enough for memory.
constexpr int kBatch = 128;

/// A scenario to generate, and the number of its first attempt.
struct Draw {
  WeightedRoundRobin::Slot slot = {};
  int attempt = 0;
};

/// Thread-safe progress within a batch, so that long batches report progress and can be canceled.
class BatchProgress {
 public:
  BatchProgress(Progress& progress, int done) : progress_(progress), done_(done) {}
  void item_done() {
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_.advance(static_cast<std::size_t>(++done_));
  }

 private:
  Progress& progress_;
  std::mutex mutex_;
  int done_;
};

class Mixer {
 public:
  Mixer(const std::vector<WeightedGenerator>& mix, const MixSettings& settings)
      : mix_(mix), settings_(settings), search_(settings.each) {}

  /// Stores the number of the successful attempt in `draw`.
  GeneratedScenario make(Draw& draw) const {
    const WeightedRoundRobin::Slot slot = draw.slot;
    const WeightedGenerator& entry = mix_[slot.generator];
    const std::string name = scenario_name(entry.name_prefix, slot.index);
    const auto candidate = [&](int attempt, std::string&) {
      RandomEngine engine(seed_of(slot, attempt));
      return std::make_optional(to_representation(entry.generator->generate(name, engine)));
    };
    const SolvableWorld found = search_.find(name, candidate, draw.attempt);
    draw.attempt = found.attempt;
    GeneratedScenario generated{found.world->scenario(), entry.generator->name(),
                                seed_of(slot, found.attempt)};
    if (settings_.describe) generated.values = settings_.describe(*found.world);
    return generated;
  }

 private:
  std::uint64_t seed_of(const WeightedRoundRobin::Slot& slot, int attempt) const {
    const WeightedGenerator& entry = mix_[slot.generator];
    const std::uint64_t scenario_seed = derive_seed(
        entry.seed, "scenario/" + entry.generator->name(), static_cast<std::uint64_t>(slot.index));
    return derive_seed(scenario_seed, "attempt", static_cast<std::uint64_t>(attempt));
  }

  Scenario to_representation(Scenario scenario) const {
    if (!settings_.representation) return scenario;
    return convert(scenario, *settings_.representation, settings_.conversion_resolution);
  }

  const std::vector<WeightedGenerator>& mix_;
  const MixSettings& settings_;
  SolvableSearch search_;
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

void generate_mix(const std::vector<WeightedGenerator>& mix, const MixSettings& settings,
                  Progress& progress, const GenerationSink& sink) {
  const Mixer mixer(mix, settings);
  WeightedRoundRobin schedule(weights_of(mix));
  progress.start("Generating scenarios", static_cast<std::size_t>(settings.each.count));
  for (int done = 0; done < settings.each.count;) {
    std::vector<Draw> draws(static_cast<std::size_t>(std::min(kBatch, settings.each.count - done)));
    for (Draw& draw : draws) draw = {schedule.next(), 0};
    while (!draws.empty()) {
      BatchProgress batch_progress(progress, done);
      std::vector<GeneratedScenario> batch =
          parallel_map(draws.size(), settings.jobs, [&](std::size_t i) {
            GeneratedScenario made = mixer.make(draws[i]);
            batch_progress.item_done();
            return made;
          });
      std::vector<Draw> redraws;
      for (const std::size_t i : sink(batch))
        redraws.push_back({draws[i].slot, draws[i].attempt + 1});
      done += static_cast<int>(draws.size() - redraws.size());
      draws = std::move(redraws);
      progress.advance(static_cast<std::size_t>(done));
    }
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
