// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/parameters.h"
#include "common/sectors.h"

#include <vector>

/// VFH+: I. Ulrich and J. Borenstein, "VFH+: Reliable Obstacle Avoidance for Fast Mobile Robots",
/// ICRA 1998, 1572-1577. Equation numbers refer to it. The histogram's obstacles are enlarged
/// already (section 2): sectors contain free distances of the robot. The mask of section 4 is
/// empty, because the robot can rotate in place.
namespace vfh_plus {

/// Lengths in the unit of the sectors: with the adapter mrpt_holonomic, reference distances.
struct Parameters {
  double window = 0.5;             ///< radius of the active window
  double threshold_high = 0.75;    ///< tau_high: a sector above is blocked, Eq. (8)
  double threshold_low = 0.6;      ///< tau_low: a sector below is free
  double wide_opening = 0.9;       ///< rad, s_max: openings wider than this are wide
  double goal_weight = 5;          ///< mu_1, Eq. (15); should exceed mu_2 + mu_3
  double heading_weight = 2;       ///< mu_2
  double previous_weight = 2;      ///< mu_3
  double slow_distance = 0.3;      ///< below this free distance the robot slows down
  double target_slow_down = 0.45;  ///< m: below this distance to the target the robot slows down

  void visit(slalom::OptionVisitor& v);
};

/// Primary polar histogram, Eqs. (2) and (6): certainty^2 (a - b d^2), with a = 1 and b such that
/// it is 0 at the border of the active window. Certainty is 1: the input is a scan, not a sonar
/// grid.
std::vector<double> primary_histogram(const reactive::Sectors& sectors, double window,
                                      double target_distance);

/// Binary polar histogram, Eq. (8): blocked above one threshold, free below the other, otherwise
/// unchanged.
void update_binary(const std::vector<double>& primary, const Parameters& parameters,
                   std::vector<char>& blocked);

/// Candidate directions, Eqs. (9) to (14): the middle of a narrow opening; for a wide one both
/// sides, half of `wide_opening` inside, and the target if it lies between them.
std::vector<double> candidates(const reactive::Opening& opening, double target_direction,
                               double wide_opening);

class VfhPlus {
 public:
  using Parameters = vfh_plus::Parameters;

  VfhPlus() = default;
  explicit VfhPlus(const Parameters& chosen) : parameters(chosen) {}
  reactive::Decision decide(const reactive::Sectors& sectors, const reactive::Point& target);

  Parameters parameters;

 private:
  double cost(double candidate, double target_direction) const;

  std::vector<char> blocked_;
  double previous_ = 0;
  reactive::SearchTurn search_;
};

}  // namespace vfh_plus
