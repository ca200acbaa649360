// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>
#include <slalom/robot/footprint.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/path.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The shortest path P* of a robot, or the reason why none exists.
struct KnownPath {
  Path path;           ///< from start to goal; empty if none exists
  double length = 0;   ///< m
  std::string reason;  ///< why no path exists
};

/// Returns P*; called only by descriptors that need it, because it runs a search.
using PathSource = std::function<const KnownPath&()>;

/// A source that searches on the first call and caches the result, which copies share. Not
/// thread-safe.
PathSource search_once(std::function<KnownPath()> search);

class BarnField;

/// Inputs of a descriptor.
struct DescriptorContext {
  const World& world;
  Footprint robot = Footprint::disc(0.25);
  double sensor_range = 8.0;  ///< m, R in the formulas
  /// P* of the disc inscribed in the robot.
  PathSource shortest;
  /// Compute confinement from exact arcs at every free cell instead of sampling.
  bool exact_confinement = false;
  /// Published version of BARN's visibility: 2021 or 2020.
  int barn_visibility = 2021;
  /// widest_bottleneck() (m) from start to goal, where it is known from the reference paths.
  std::optional<double> bottleneck = std::nullopt;
  /// The grid of BARN's metrics for this world and this P*: made by the first of them.
  mutable std::shared_ptr<const BarnField> barn_field = nullptr;

  double robot_radius() const { return robot.inscribed_radius(); }  ///< m, inscribed radius
};

/// A parameter on which a value depends, as "key=value"; "" where it does not apply.
using DescriptorParameter = std::string (*)(const DescriptorContext& context);

/// A scalar property of a scenario: what it is, and the function that computes it. Deterministic:
/// equal scenarios and parameters give equal values.
struct Descriptor {
  QuantityInfo info;
  std::vector<DescriptorParameter> depends_on;
  Value (*compute)(const DescriptorContext& context);

  /// The key of the value, with the parameters on which it depends, e.g. "robot_radius=0.25".
  ValueKey key(const DescriptorContext& context) const;
};

/// All descriptors, in the order of definitions.md; the table is in descriptor_table.cpp.
const std::vector<Descriptor>& all_descriptors();
std::vector<std::string> descriptor_ids();  ///< of all of them

/// The ids of the descriptors that are about moving obstacles, in the order of all_descriptors().
/// Without a mover in the scenario they are NA.
const std::vector<std::string>& mover_descriptor_ids();

/// The descriptor with this id; throws Error (Usage) with the most similar id.
const Descriptor& descriptor(const std::string& id);

}  // namespace slalom
