#include <slalom/commands/describe_scenario.h>
#include <slalom/references/exact_shortest.h>

namespace slalom {
namespace {

/// Length of the exact shortest path, searched only when a descriptor asks.
Value shortest_length(const World& world, double robot_radius) {
  constexpr double kGap = 0.01;
  const auto& start = world.scenario().start();
  std::string reason;
  const auto shortest = exact_shortest_path(
      {world, robot_radius, {start.x, start.y}, world.scenario().goal()}, kGap, reason);
  return shortest ? Value::of(shortest->length) : Value::na(reason);
}

}  // namespace

std::vector<std::pair<QuantityInfo, Value>> describe_scenario(const Scenario& scenario,
                                                              const DescribeOptions& options,
                                                              DescriptorStore& store) {
  const World world(scenario, options.resolution);
  const DescriptorContext context{
      world, options.robot_radius, options.sensor_range,
      [&world, &options] { return shortest_length(world, options.robot_radius); }};
  std::vector<std::pair<QuantityInfo, Value>> values;
  if (options.ids.empty())
    for (const auto& wanted : all_descriptors())
      values.emplace_back(wanted->info(), describe(*wanted, context, &store));
  for (const std::string& id : options.ids)
    values.emplace_back(descriptor(id).info(), describe(descriptor(id), context, &store));
  return values;
}

}  // namespace slalom
