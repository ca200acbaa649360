// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/parameters.h"
#include "common/valleys.h"

/// Smooth Nearness-Diagram navigation: J. W. Durham and F. Bullo, "Smooth Nearness-Diagram
/// Navigation", IROS 2008, 690-695. One motion law for all situations: the direction through the
/// best valley, deflected by the weighted mean of all threats.
namespace smooth_nd {

/// Lengths in the unit of the sectors: with the adapter mrpt_holonomic, reference distances.
struct Parameters {
  double safety_distance = 0.15;  ///< D_s: obstacles closer than this are threats
  double gap = 0.2;               ///< minimum discontinuity of the free distance at a gap
  double passable = 0.15;         ///< sectors with a smaller free distance are closed
  double wide_valley =
      0.9;  ///< rad, s_max: a wide valley is entered at half this angle from its gap
  double slow_angle = 1.57;        ///< rad: heading deviation at which the speed is minimal
  double field_of_view = 3.1416;   ///< rad: valleys outside it are ignored
  double slow_distance = 0.3;      ///< below this free distance the robot slows down
  double target_slow_down = 0.45;  ///< m: below this distance to the target the robot slows down

  void visit(slalom::OptionVisitor& v);
};

/// Threat s_i = sat((D_s - D_i) / D_s) in [0, 1], D_i the free distance in sector i (section III-B;
/// sectors include the robot's radius).
double threat(double free_distance, double safety_distance);

/// Mean deflection of section III-B: each threat turns the direction away from its obstacle, at
/// most to the opposite direction, weighted by the square of the threat.
double deflection(const reactive::Sectors& sectors, double direction, double safety_distance);

class SmoothNd {
 public:
  using Parameters = smooth_nd::Parameters;

  SmoothNd() = default;
  explicit SmoothNd(const Parameters& chosen) : parameters(chosen) {}
  reactive::Decision decide(const reactive::Sectors& sectors, const reactive::Point& target);

  Parameters parameters;

 private:
  reactive::SearchTurn search_;
};

}  // namespace smooth_nd
