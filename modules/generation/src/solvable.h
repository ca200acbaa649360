#pragma once

#include <slalom/generation/generator.h>
#include <slalom/scenario/world.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace slalom {

/// A certified scenario, with what was derived from it on the way.
struct SolvableWorld {
  std::unique_ptr<const World> world;
  int attempt = 0;  ///< with which it was drawn
};

/// Draws candidates until one has a certified path for the robot; counts why others were not taken.
class SolvableSearch {
 public:
  explicit SolvableSearch(const GenerationTask& task) : task_(task) {}

  /// A candidate for attempt `attempt`, or nullopt with the reason why there is none.
  using Draw = std::function<std::optional<Scenario>(int attempt, std::string& reason)>;

  /// Begins with `first_attempt`: attempts before it gave contents that were there already. Throws
  /// Error (Job) naming the scenario when the attempts are used up.
  SolvableWorld find(const std::string& name, const Draw& draw, int first_attempt = 0) const;

 private:
  bool is_certified(const World& world, std::string& reason) const;

  const GenerationTask& task_;
};

/// "PREFIX_0007".
std::string scenario_name(const std::string& prefix, int index);

}  // namespace slalom
