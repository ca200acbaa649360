#pragma once

#include <slalom/core/value.h>
#include <slalom/generation/generator.h>
#include <slalom/scenario/world.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace slalom {

/// A value of a scenario as a DescriptorStore takes it.
struct GeneratedValue {
  std::string id;  ///< of the descriptor
  int version = 1;
  std::string parameters;
  Value value;
};

/// A scenario and where it came from.
struct GeneratedScenario {
  Scenario scenario;
  std::string generator;  ///< name of its family, "" when it was not generated
  /// An engine of this seed draws it again from the same options.
  std::optional<std::uint64_t> seed = std::nullopt;
  std::vector<GeneratedValue> values = {};
};

/// One family of a mix.
struct GeneratorShare {
  std::shared_ptr<const Generator> generator;
  double weight = 1;        ///< above 0
  std::uint64_t seed = 1;   ///< scenario k of this family depends on its options, this seed and k
  std::string name_prefix;  ///< they are named PREFIX_0000, PREFIX_0001, ...
};

/// How scenarios are made from a mix.
struct MixTask {
  GenerationTask each;  ///< count for all families together; seed and name_prefix are not used
  int jobs = 1;         ///< threads; the result is the same for any number
  /// Into which representation each candidate is turned before it is certified; none: as the
  /// family draws it.
  std::optional<Representation> representation = std::nullopt;
  double conversion_resolution = 0.05;  ///< m, of that representation
  /// Called for each certified scenario, by several threads at once: the values to keep with it.
  std::function<std::vector<GeneratedValue>(const World&)> describe = {};
};

/// Takes scenarios in order, a part of them at a time. Returns the indexes of those whose content
/// was there before: others are drawn in their place and given in a part of their own.
using GenerationSink =
    std::function<std::vector<std::size_t>(std::vector<GeneratedScenario>& part)>;

/// Draws task.each.count certified scenarios and gives them to the sink in an order that depends on
/// nothing but the weights: the family that is furthest behind its share comes next. Memory does
/// not grow with the count. Throws as generate_solvable() does; the sink may have taken scenarios
/// by then.
void generate_mix(const std::vector<GeneratorShare>& mix, const MixTask& task, Progress& progress,
                  const GenerationSink& sink);

/// Collects what a sink is given, equal contents once.
class DistinctScenarios {
 public:
  std::vector<std::size_t> add(std::vector<GeneratedScenario>& part);
  std::vector<Scenario> take() { return std::move(scenarios_); }

 private:
  std::set<std::string> hashes_;
  std::vector<Scenario> scenarios_;
};

/// Whose turn it is, by weights: the family that is furthest behind its share, of equals the first.
class ShareSchedule {
 public:
  explicit ShareSchedule(std::vector<double> weights);

  struct Turn {
    std::size_t family;
    int index;  ///< how many turns it had before
  };
  Turn next();

 private:
  std::vector<double> weights_;
  std::vector<int> turns_;
  double total_weight_ = 0;
};

}  // namespace slalom
