// SPDX-License-Identifier: BSD-3-Clause
#include "potential_field/potential_field.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>

#include <algorithm>

namespace potential_field {

using namespace reactive;

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("attraction", attraction, "-", "force towards the goal", Range::at_least(0));
  v.option("clearance", clearance, "length",
           "here the force of an obstacle equals the attraction; less than influence",
           Range::at_least(1e-3));
  v.option("influence", influence, "length", "rho_0: obstacles farther away exert no force",
           Range::at_least(1e-3));
  v.option("slow_distance", slow_distance, "length",
           "below this free distance the robot slows down", Range::at_least(0));
  v.option("target_slow_down", target_slow_down, "m",
           "below this distance to the target the robot slows down", Range::at_least(0));
}

Point attraction(const Point& target, double magnitude) {
  const double far = slalom::math::hypot(target.x, target.y);
  if (far == 0) return {};
  return {magnitude * target.x / far, magnitude * target.y / far};
}

double repulsion_gain(const Parameters& parameters) {
  const double c = parameters.clearance;
  return parameters.attraction * c * c / (1 / c - 1 / parameters.influence);
}

double repulsion(double distance, double eta, double influence) {
  const double rho = std::max(distance, 0.01 * influence);
  if (rho >= influence) return 0;
  return eta * (1 / rho - 1 / influence) / (rho * rho);
}

Point repulsion_of(const Sectors& sectors, const Parameters& parameters) {
  const std::size_t n = sectors.count();
  // Obstacles are runs of near sectors: mark these as open.
  Sectors near = sectors;
  for (double& free_distance : near.free_distances)
    free_distance = free_distance < parameters.influence ? 1 : 0;
  const double eta = repulsion_gain(parameters);
  Point sum;
  for (const SectorRun& obstacle : open_runs(near, 0.5)) {
    std::size_t nearest = obstacle.first;
    for (std::size_t i = 0; i < obstacle.length; ++i)
      if (sectors.free_distances[(obstacle.first + i) % n] < sectors.free_distances[nearest])
        nearest = (obstacle.first + i) % n;
    const double force = repulsion(sectors.free_distances[nearest], eta, parameters.influence);
    sum.x -= force * slalom::math::cos(sectors.direction(nearest));
    sum.y -= force * slalom::math::sin(sectors.direction(nearest));
  }
  return sum;
}

PotentialField::PotentialField(const Parameters& chosen) : parameters(chosen) {
  if (chosen.clearance >= chosen.influence)
    throw slalom::usage_error("clearance", "is not less than influence");
}

Decision PotentialField::decide(const Sectors& sectors, const Point& target) {
  const Point towards = attraction(target, parameters.attraction);
  const Point away = repulsion_of(sectors, parameters);
  const Point force{towards.x + away.x, towards.y + away.y};
  const double magnitude = slalom::math::hypot(force.x, force.y);
  const double direction = slalom::math::atan2(force.y, force.x);
  const double target_distance = slalom::math::hypot(target.x, target.y);
  // The robot stops where the forces cancel.
  const double speed = std::min(1.0, magnitude / std::max(1e-9, parameters.attraction));
  if (speed < 0.05) return {direction, 0};
  return {direction, speed * speed_fraction(sectors.free_distance(direction), target_distance,
                                            parameters.slow_distance,
                                            parameters.target_slow_down * sectors.meter)};
}

}  // namespace potential_field
