// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/campaign_options.h>
#include <slalom/campaign/describe_scenario.h>
#include <slalom/references/exact_shortest.h>

namespace slalom {
namespace {

KnownPath shortest_path(const World& world, double robot_radius) {
  const auto& start = world.scenario().start();
  std::string reason;
  const auto shortest = exact_shortest_path(
      {world, robot_radius, {start.x, start.y}, world.scenario().goal()}, reason);
  return shortest ? KnownPath{shortest->path, shortest->length, ""} : KnownPath{{}, 0, reason};
}

}  // namespace

DescribeOptions describe_options(const CampaignOptions& options) {
  DescribeOptions result;
  result.ids = options.descriptors;
  result.robot = options.robot.shape();
  result.sensor_range = options.sensor.max_range;
  result.resolution = options.simulation.resolution;
  result.exact_confinement = options.exact_confinement;
  return result;
}

std::vector<KeyedValue> describe_scenario(const Scenario& scenario, const DescribeOptions& options,
                                          DescriptorStore& store,
                                          const DescribeObserver& observer) {
  return describe_world(World(scenario, options.resolution), options, store, observer);
}

std::vector<KeyedValue> describe_world(const World& world, const DescribeOptions& options,
                                       DescriptorStore& store, const DescribeObserver& observer) {
  const double radius = options.robot.inscribed_radius();
  const DescriptorContext context{
      world,
      options.robot,
      options.sensor_range,
      search_once([&world, radius] { return shortest_path(world, radius); }),
      options.exact_confinement,
      options.barn_visibility};
  std::vector<KeyedValue> values;
  const auto add = [&](const Descriptor& requested) {
    values.push_back(describe(requested, context, store));
    if (observer) observer(values.back());
  };
  if (options.ids.empty())
    for (const Descriptor& descriptor : all_descriptors()) add(descriptor);
  for (const std::string& id : options.ids) add(descriptor(id));
  return values;
}

}  // namespace slalom
