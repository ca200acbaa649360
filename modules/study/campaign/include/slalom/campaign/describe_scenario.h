// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>
#include <slalom/descriptors/descriptor_cache.h>
#include <slalom/scenario/world.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

struct CampaignOptions;

/// The descriptors to compute and the robot and sensor for which they are computed.
struct DescribeOptions {
  std::vector<std::string> ids;  ///< of descriptors; empty for all
  Footprint robot = Footprint::disc(0.25);
  double sensor_range = 8;   ///< m
  double resolution = 0.05;  ///< m, for scenarios that are not grids
  bool exact_confinement = false;
  int barn_visibility = 2021;  ///< which published version, 2021 or 2020
};

/// The descriptors, robot and sensor of a campaign.
DescribeOptions describe_options(const CampaignOptions& options);

/// Called with each value as soon as it is available. It may throw to cancel.
using DescribeObserver = std::function<void(const KeyedValue&)>;

/// The descriptor values of a scenario in the order of the ids. Values that are missing in `store`
/// are computed and stored there.
std::vector<KeyedValue> describe_scenario(const Scenario& scenario, const DescribeOptions& options,
                                          DescriptorStore& store,
                                          const DescribeObserver& observer = {});

/// The same for an existing world; options.resolution has no effect.
std::vector<KeyedValue> describe_world(const World& world, const DescribeOptions& options,
                                       DescriptorStore& store,
                                       const DescribeObserver& observer = {});

}  // namespace slalom
