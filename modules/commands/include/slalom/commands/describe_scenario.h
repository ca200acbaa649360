#pragma once

#include <slalom/core/value.h>
#include <slalom/descriptors/descriptor_cache.h>
#include <slalom/scenario/world.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// For whom a scenario is described.
struct DescribeOptions {
  std::vector<std::string> ids;  ///< of descriptors; empty for all
  Footprint robot = Footprint::disc(0.25);
  double sensor_range = 8;   ///< m
  double resolution = 0.05;  ///< m, for scenarios that are not grids
  bool exact_confinement = false;
  int barn_visibility = 2021;  ///< which published version, 2021 or 2020
};

/// What one descriptor says of a scenario.
struct DescribedValue {
  QuantityInfo info;
  Value value;
  std::string parameters;  ///< that the value depends on, "key=value;..."
  /// Wall-clock time (ms) it took to look up or to compute. What several descriptors need (cells,
  /// distances, the shortest path) counts for the first of them.
  double time_ms = 0;
};

/// Is shown each value as soon as it is known. What it throws ends the work.
using DescribeObserver = std::function<void(const DescribedValue&)>;

/// The values of a scenario's descriptors in the order of the ids: looked up in `store`, what is
/// missing computed and kept there.
std::vector<DescribedValue> describe_scenario(const Scenario& scenario,
                                              const DescribeOptions& options,
                                              DescriptorStore& store,
                                              const DescribeObserver& observer = {});

/// The same of a world that is there already; options.resolution has no effect.
std::vector<DescribedValue> describe_world(const World& world, const DescribeOptions& options,
                                           DescriptorStore& store,
                                           const DescribeObserver& observer = {});

}  // namespace slalom
