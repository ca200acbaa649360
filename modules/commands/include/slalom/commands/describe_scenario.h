#pragma once

#include <slalom/core/value.h>
#include <slalom/descriptors/descriptor_cache.h>
#include <slalom/scenario/world.h>

#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// For whom a scenario is described.
struct DescribeOptions {
  std::vector<std::string> ids;  ///< of descriptors; empty for all
  double robot_radius = 0.25;    ///< m
  double sensor_range = 8;       ///< m
  double resolution = 0.05;      ///< m, for scenarios that are not grids
};

/// The values of a scenario's descriptors in the order of the ids: looked up in `store`, what is
/// missing computed and kept there.
std::vector<std::pair<QuantityInfo, Value>> describe_scenario(const Scenario& scenario,
                                                              const DescribeOptions& options,
                                                              DescriptorStore& store);

}  // namespace slalom
