#include <slalom/commands/describe_scenario.h>
#include <slalom/references/exact_shortest.h>

#include <chrono>

namespace slalom {
namespace {

KnownPath shortest_path(const World& world, double robot_radius) {
  constexpr double kGap = 0.01;
  const auto& start = world.scenario().start();
  std::string reason;
  const auto shortest = exact_shortest_path(
      {world, robot_radius, {start.x, start.y}, world.scenario().goal()}, kGap, reason);
  return shortest ? KnownPath{shortest->path, shortest->length, ""} : KnownPath{{}, 0, reason};
}

DescribedValue describe_timed(const Descriptor& descriptor, const DescriptorContext& context,
                              DescriptorStore& store) {
  const auto begin = std::chrono::steady_clock::now();
  const Value value = describe(descriptor, context, &store);
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  return {descriptor.info(), value, descriptor.parameters(context), taken.count()};
}

}  // namespace

std::vector<DescribedValue> describe_scenario(const Scenario& scenario,
                                              const DescribeOptions& options,
                                              DescriptorStore& store,
                                              const DescribeObserver& observer) {
  return describe_world(World(scenario, options.resolution), options, store, observer);
}

std::vector<DescribedValue> describe_world(const World& world, const DescribeOptions& options,
                                           DescriptorStore& store,
                                           const DescribeObserver& observer) {
  const double radius = options.robot.inscribed_radius();
  const DescriptorContext context{
      world,
      options.robot,
      options.sensor_range,
      search_once([&world, radius] { return shortest_path(world, radius); }),
      options.exact_confinement,
      options.barn_visibility};
  std::vector<DescribedValue> values;
  const auto add = [&](const Descriptor& wanted) {
    values.push_back(describe_timed(wanted, context, store));
    if (observer) observer(values.back());
  };
  if (options.ids.empty())
    for (const auto& wanted : all_descriptors()) add(*wanted);
  for (const std::string& id : options.ids) add(descriptor(id));
  return values;
}

}  // namespace slalom
