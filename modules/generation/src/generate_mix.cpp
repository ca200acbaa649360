#include "solvable.h"

#include <slalom/generation/generate_mix.h>
#include <slalom/generation/parallel.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>

namespace slalom {
namespace {

/// So many are drawn before they are handed on in order: enough for threads to be busy, few enough
/// for memory.
constexpr int kBatch = 128;

class Mixer {
 public:
  Mixer(const std::vector<GeneratorShare>& mix, const MixTask& task)
      : mix_(mix), task_(task), search_(task.each) {}

  struct Made {
    GeneratedScenario generated;
    int attempt;
  };

  Made make(const ShareSchedule::Turn& turn, int first_attempt = 0) const {
    const GeneratorShare& share = mix_[turn.family];
    const std::string name = scenario_name(share.name_prefix, turn.index);
    const auto draw = [&](int attempt, std::string&) {
      RandomEngine engine(seed_of(turn, attempt));
      return std::make_optional(represented(share.generator->generate(name, engine)));
    };
    const SolvableWorld found = search_.find(name, draw, first_attempt);
    GeneratedScenario generated{found.world->scenario(), share.generator->name(),
                                seed_of(turn, found.attempt)};
    if (task_.describe) generated.values = task_.describe(*found.world);
    return {std::move(generated), found.attempt};
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
    std::vector<ShareSchedule::Turn> turns(
        static_cast<std::size_t>(std::min(kBatch, task.each.count - done)));
    for (ShareSchedule::Turn& turn : turns) turn = schedule.next();
    auto made =
        parallel_map(turns.size(), task.jobs, [&](std::size_t i) { return mixer.make(turns[i]); });
    for (std::size_t i = 0; i < made.size(); ++i) {
      while (!sink(made[i].generated)) made[i] = mixer.make(turns[i], made[i].attempt + 1);
      progress.advance(static_cast<std::size_t>(++done));
    }
  }
  progress.finish();
}

}  // namespace slalom
