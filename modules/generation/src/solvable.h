#pragma once

#include <slalom/generation/generator.h>
#include <slalom/scenario/world.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace slalom {

/// Draws candidates until one has a certified path for the robot and was not there before; counts
/// why others were not taken.
class SolvableSearch {
 public:
  explicit SolvableSearch(const GenerationTask& task) : task_(task) {}

  /// A candidate for attempt `attempt`, or nullopt with the reason why there is none.
  using Draw = std::function<std::optional<Scenario>(int attempt, std::string& reason)>;

  /// Throws Error (Job) naming the scenario when the attempts are used up.
  Scenario find(const std::string& name, const Draw& draw);

  /// "PREFIX_0007".
  std::string name_of(int index) const;

 private:
  bool is_certified(const Scenario& candidate, std::string& reason) const;

  const GenerationTask& task_;
  std::set<std::string> hashes_;
};

}  // namespace slalom
