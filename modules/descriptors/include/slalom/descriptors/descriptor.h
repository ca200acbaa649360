#pragma once

#include <slalom/core/value.h>
#include <slalom/scenario/world.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// What a descriptor may look at.
struct DescriptorContext {
  const World& world;
  double robot_radius = 0.25;  ///< m
  double sensor_range = 8.0;   ///< m, R in the formulas
  /// Length (m) of the shortest path P* of this robot, or NA with the reason. Called only by
  /// descriptors that need it, because it costs a search.
  std::function<Value()> shortest_length;
};

/// One number about a place (Strategy). Deterministic: the same scenario and parameters, the same
/// value.
class Descriptor {
 public:
  virtual ~Descriptor() = default;
  virtual QuantityInfo info() const = 0;
  /// The parameters that the value depends on, as "key=value;...", "" for none: part of the cache
  /// key, so "robot_radius=0.25" for those that depend on the robot.
  virtual std::string parameters(const DescriptorContext& context) const = 0;
  virtual Value compute(const DescriptorContext& context) const = 0;
};

/// All descriptors, in the order of definitions.md: the one list to add a line to.
const std::vector<std::shared_ptr<const Descriptor>>& all_descriptors();

/// The descriptor with this id; throws Error (Usage) naming the nearest id.
const Descriptor& descriptor(const std::string& id);

}  // namespace slalom
