// Evaluates a method, given as a lambda, against one of MRPT's in 100 random scenarios.
#include <slalom/evaluate.h>
#include <slalom/mrpt_nav/holonomic_method.h>

#include <algorithm>
#include <cmath>
#include <iostream>

int main() {
  slalom::RandomGeneratorOptions family;  // discs and polygons in a room of 12 m x 12 m
  family.obstacles.max_obstacles = 25;
  const auto scenarios = slalom::generate(family, 100, /*seed=*/1);

  slalom::Methods methods;
  methods.add("nd", slalom::mrpt_holonomic("CHolonomicND"));
  methods.add("mine", [](const slalom::Observation& seen) {
    // Turns towards the goal, and slows down for what is ahead.
    const double bearing = std::atan2(seen.goal_in_robot.y, seen.goal_in_robot.x);
    const double ahead = seen.scan->getScanRange(seen.scan->getScanSize() / 2);  // m
    const double v = std::abs(bearing) < 0.5 ? std::clamp(ahead - 0.5, 0.0, 1.0) : 0.0;
    return slalom::Command{v, std::clamp(2 * bearing, -1.5, 1.5)};  // m/s, rad/s
  });

  slalom::Options options;
  options.robot.radius = 0.25;  // m
  options.workers = 2;
  const auto table = slalom::evaluate(methods, scenarios, options);
  std::cout << slalom::cross_table(table, "confinement:4", {"success", "optimality"});
}
