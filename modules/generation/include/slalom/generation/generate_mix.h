// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>
#include <slalom/core/wall_clock.h>
#include <slalom/generation/generator.h>
#include <slalom/generation/sample_people.h>
#include <slalom/generation/walkers.h>
#include <slalom/scenario/world.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace slalom {

/// A scenario and its provenance.
struct GeneratedScenario {
  Scenario scenario;
  std::string generator;  ///< name of its generator, "" if it was not generated
  /// An engine with this seed reproduces it from the same options.
  std::optional<std::uint64_t> seed = std::nullopt;
  std::vector<KeyedValue> values = {};
};

/// One generator of a mix.
struct WeightedGenerator {
  std::shared_ptr<const Generator> generator;
  double weight = 1;        ///< above 0
  std::uint64_t seed = 1;   ///< scenario k depends on the options, this seed and k
  std::string name_prefix;  ///< names are PREFIX_0000, PREFIX_0001, ...
};

/// How scenarios are generated from a mix.
struct MixSettings {
  GenerationSettings each;  ///< count: total of all generators; seed, name_prefix: unused
  int jobs = 1;             ///< threads; the result does not depend on it
  /// The representation to which each candidate is converted before certification; none: as
  /// generated.
  std::optional<Representation> representation = std::nullopt;
  double conversion_resolution = 0.05;  ///< m, resolution of that conversion
  WalkerOptions walkers = {};           ///< added to each certified scenario
  PeopleOptions people = {};            ///< likewise
  /// Returns the values to store with a certified scenario; called concurrently.
  std::function<std::vector<KeyedValue>(const World&)> describe = {};
};

/// Consumes scenarios in order, in batches. Returns the indexes of duplicates (scenarios whose
/// content was consumed before); they are replaced in a further batch.
using GenerationSink =
    std::function<std::vector<std::size_t>(std::vector<GeneratedScenario>& batch)>;

/// A scenario of a mix: number `index` of a generator, and the first attempt to make it.
struct MixDraw {
  std::size_t generator = 0;
  int index = 0, attempt = 0;
};

/// State of an interrupted mix.
struct MixState {
  int begun = 0;                 ///< scenarios of the weighted round robin so far
  std::vector<MixDraw> round;    ///< of those: not generated yet
  std::vector<MixDraw> redraws;  ///< of those: duplicates that the next round replaces

  int done() const { return begun - static_cast<int>(round.size() + redraws.size()); }
};

/// The scenarios of a mix part by part, from the beginning or from where it was interrupted. Their
/// order depends only on the weights and on the duplicates.
class MixStream {
 public:
  /// `clock` limits a part to about a second, or to one scenario that takes longer.
  MixStream(std::vector<WeightedGenerator> mix, MixSettings settings, MixState state = {},
            WallClock clock = steady_seconds);
  ~MixStream();
  MixStream(MixStream&&) noexcept;

  bool finished() const;
  /// The next scenarios; throws as generate_solvable() does.
  std::vector<GeneratedScenario> next(Progress& progress);
  /// To be called after next(), with the indexes of the duplicates in that part.
  void commit_part(const std::vector<std::size_t>& duplicates);
  const MixState& state() const;
  int count() const;  ///< scenarios in total

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Generates settings.each.count certified scenarios and passes them to the sink in an order that
/// depends only on the weights (weighted round robin). Memory does not grow with the count. Throws
/// as generate_solvable() does; the sink may have consumed scenarios by then.
void generate_mix(const std::vector<WeightedGenerator>& mix, const MixSettings& settings,
                  Progress& progress, const GenerationSink& sink);

/// A sink that collects scenarios without duplicates.
class DistinctScenarios {
 public:
  std::vector<std::size_t> add(std::vector<GeneratedScenario>& batch);
  std::vector<Scenario> take() { return std::move(scenarios_); }

 private:
  std::set<std::string> hashes_;
  std::vector<Scenario> scenarios_;
};

/// Weighted round robin over generators: the one with the largest deficit is next; on ties the
/// first.
class WeightedRoundRobin {
 public:
  explicit WeightedRoundRobin(std::vector<double> weights);

  struct Slot {
    std::size_t generator;
    int index;  ///< number of previous slots of this generator
  };
  Slot next();

 private:
  std::vector<double> weights_;
  std::vector<int> counts_;
  double total_weight_ = 0;
};

}  // namespace slalom
