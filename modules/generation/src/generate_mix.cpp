#include "solvable.h"

#include <slalom/generation/generate_mix.h>
#include <slalom/generation/parallel.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>
#include <mutex>

namespace slalom {
namespace {

/// So many are drawn before they are handed on in order: enough for threads to be busy, few enough
/// for memory.
constexpr int kBatch = 128;

/// What is drawn next, and with which attempt that begins.
struct Draw {
  ShareSchedule::Turn turn = {};
  int attempt = 0;
};

/// Tells one by one what several threads have made, so that a long part can be watched and ended.
class PartProgress {
 public:
  PartProgress(Progress& progress, int done) : progress_(progress), done_(done) {}
  void made_one() {
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
  Mixer(const std::vector<GeneratorShare>& mix, const MixTask& task)
      : mix_(mix), task_(task), search_(task.each) {}

  /// Notes in `draw` with which attempt it was found.
  GeneratedScenario make(Draw& draw) const {
    const ShareSchedule::Turn turn = draw.turn;
    const GeneratorShare& share = mix_[turn.family];
    const std::string name = scenario_name(share.name_prefix, turn.index);
    const auto candidate = [&](int attempt, std::string&) {
      RandomEngine engine(seed_of(turn, attempt));
      return std::make_optional(represented(share.generator->generate(name, engine)));
    };
    const SolvableWorld found = search_.find(name, candidate, draw.attempt);
    draw.attempt = found.attempt;
    GeneratedScenario generated{found.world->scenario(), share.generator->name(),
                                seed_of(turn, found.attempt)};
    if (task_.describe) generated.values = task_.describe(*found.world);
    return generated;
  }

 private:
  std::uint64_t seed_of(const ShareSchedule::Turn& turn, int attempt) const {
    const GeneratorShare& share = mix_[turn.family];
    const std::uint64_t scenario_seed = derive_seed(
        share.seed, "scenario/" + share.generator->name(), static_cast<std::uint64_t>(turn.index));
    return derive_seed(scenario_seed, "attempt", static_cast<std::uint64_t>(attempt));
  }

  Scenario represented(Scenario drawn) const {
    if (!task_.representation) return drawn;
    return convert(drawn, *task_.representation, task_.conversion_resolution);
  }

  const std::vector<GeneratorShare>& mix_;
  const MixTask& task_;
  SolvableSearch search_;
};

std::vector<double> weights_of(const std::vector<GeneratorShare>& mix) {
  std::vector<double> weights;
  for (const GeneratorShare& share : mix) weights.push_back(share.weight);
  return weights;
}

}  // namespace

ShareSchedule::ShareSchedule(std::vector<double> weights)
    : weights_(std::move(weights)), turns_(weights_.size(), 0) {
  for (const double weight : weights_) total_weight_ += weight;
}

ShareSchedule::Turn ShareSchedule::next() {
  double turns = 1;
  for (const int had : turns_) turns += had;
  std::size_t furthest_behind = 0;
  double most = -1;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const double behind = turns * weights_[i] / total_weight_ - turns_[i];
    if (behind <= most) continue;
    most = behind;
    furthest_behind = i;
  }
  return {furthest_behind, turns_[furthest_behind]++};
}

void generate_mix(const std::vector<GeneratorShare>& mix, const MixTask& task, Progress& progress,
                  const GenerationSink& sink) {
  const Mixer mixer(mix, task);
  ShareSchedule schedule(weights_of(mix));
  progress.start("Generating scenarios", static_cast<std::size_t>(task.each.count));
  for (int done = 0; done < task.each.count;) {
    std::vector<Draw> draws(static_cast<std::size_t>(std::min(kBatch, task.each.count - done)));
    for (Draw& draw : draws) draw = {schedule.next(), 0};
    while (!draws.empty()) {
      PartProgress part_progress(progress, done);
      std::vector<GeneratedScenario> part =
          parallel_map(draws.size(), task.jobs, [&](std::size_t i) {
            GeneratedScenario made = mixer.make(draws[i]);
            part_progress.made_one();
            return made;
          });
      std::vector<Draw> again;
      for (const std::size_t i : sink(part)) again.push_back({draws[i].turn, draws[i].attempt + 1});
      done += static_cast<int>(draws.size() - again.size());
      draws = std::move(again);
      progress.advance(static_cast<std::size_t>(done));
    }
  }
  progress.finish();
}

std::vector<std::size_t> DistinctScenarios::add(std::vector<GeneratedScenario>& part) {
  std::vector<std::size_t> there_before;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (hashes_.insert(part[i].scenario.hash()).second) {
      scenarios_.push_back(std::move(part[i].scenario));
    } else {
      there_before.push_back(i);
    }
  }
  return there_before;
}

}  // namespace slalom
