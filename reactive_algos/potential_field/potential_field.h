// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/parameters.h"
#include "common/sectors.h"

/// Artificial potential field: O. Khatib, "Real-Time Obstacle Avoidance for Manipulators and Mobile
/// Robots", International Journal of Robotics Research 5(1), 1986, 90-98. The classic lower
/// baseline.
namespace potential_field {

/// Lengths in the unit of the sectors: with the adapter mrpt_holonomic, reference distances.
struct Parameters {
  double attraction = 1.0;         ///< force towards the goal
  double clearance = 0.05;         ///< where the force of an obstacle equals the attraction
  double influence = 0.25;         ///< rho_0: obstacles farther away exert no force
  double slow_distance = 0.3;      ///< below this free distance the robot slows down
  double target_slow_down = 0.45;  ///< m: below this distance to the target the robot slows down

  void visit(slalom::OptionVisitor& v);
};

/// The attraction: a force of constant magnitude towards the target, as follows from a velocity
/// limit (section on joint and velocity limits: the robot moves to the goal at maximum speed).
reactive::Point attraction(const reactive::Point& target, double magnitude);

/// eta: the force of an obstacle at the wished clearance equals the attraction.
double repulsion_gain(const Parameters& parameters);

/// FIRAS: eta (1 / rho - 1 / rho_0) / rho^2, directed away from the obstacle; 0 beyond rho_0.
double repulsion(double distance, double eta, double influence);

/// Sum of the repulsions of all obstacles. Each obstacle exerts one force, from its closest point:
/// the sector with the smallest free distance in its run of sectors.
reactive::Point repulsion_of(const reactive::Sectors& sectors, const Parameters& parameters);

class PotentialField {
 public:
  using Parameters = potential_field::Parameters;

  PotentialField() = default;
  /// Throws slalom::Error if the clearance is not below the influence.
  explicit PotentialField(const Parameters& chosen);
  reactive::Decision decide(const reactive::Sectors& sectors, const reactive::Point& target);

  Parameters parameters;
};

}  // namespace potential_field
