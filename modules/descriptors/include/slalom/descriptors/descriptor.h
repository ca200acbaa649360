#pragma once

#include <slalom/core/value.h>
#include <slalom/robot/footprint.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/path.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// The shortest path P* of a robot, or why there is none.
struct KnownPath {
  Path path;           ///< from start to goal; empty when there is none
  double length = 0;   ///< m
  std::string reason;  ///< why there is none
};

/// Gives P*; called only by descriptors that need it, because it costs a search.
using PathSource = std::function<const KnownPath&()>;

/// A source that searches when it is first asked, and never again. Copies share what was found. Not
/// for several threads at once.
PathSource search_once(std::function<KnownPath()> search);

/// What a descriptor may look at.
struct DescriptorContext {
  const World& world;
  Footprint robot = Footprint::disc(0.25);
  double sensor_range = 8.0;  ///< m, R in the formulas
  /// P* of the disc inscribed in the robot.
  PathSource shortest;
  /// Confinement by summing up exact arcs at every free cell, instead of a sample.
  bool exact_confinement = false;
  /// Which of the two published versions of BARN's visibility: 2021 or 2020.
  int barn_visibility = 2021;

  double robot_radius() const { return robot.inscribed_radius(); }  ///< m, of that disc
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
