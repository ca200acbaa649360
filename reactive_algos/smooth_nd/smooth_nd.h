#pragma once

#include "common/settings.h"
#include "common/valleys.h"

/// Smooth Nearness-Diagram navigation: J. W. Durham and F. Bullo, "Smooth Nearness-Diagram
/// Navigation", IROS 2008, 690-695. One law of motion for all situations: the direction through the
/// best valley, turned away from all near obstacles by the average of their threats.
namespace smooth_nd {

/// Lengths in the unit of the sectors: with the adapter mrpt_holonomic, reference distances.
struct Parameters {
  double safety_distance = 0.15;   ///< D_s: obstacles nearer than that are threats
  double gap = 0.2;                ///< a jump of the way by more is a gap
  double passable = 0.15;          ///< sectors whose way is shorter are closed
  double wide_valley = 0.9;        ///< rad, s_max: how far from its gap a wide valley is entered
  double slow_angle = 1.57;        ///< rad: the robot stands at this deviation from straight ahead
  double field_of_view = 3.1416;   ///< rad: valleys are looked for ahead only, as a scan sees them
  double slow_distance = 0.3;      ///< slower when less way than this is ahead
  double target_slow_down = 0.15;  ///< slower when the target is nearer
};

/// Threat s_i = sat((D_s - D_i) / D_s) in [0, 1], D_i the way left in sector i (section III-B; the
/// robot's radius is in the sectors).
double threat(double way, double safety_distance);

/// Mean deflection of section III-B: each threat turns the direction away from its obstacle, by up
/// to the angle to straight away from it, weighted by the square of the threat.
double deflection(const reactive::Sectors& sectors, double direction, double safety_distance);

class SmoothNd {
 public:
  using Parameters = smooth_nd::Parameters;
  using Settings = reactive::Setting<Parameters>[8];
  static const Settings& settings();

  SmoothNd() = default;
  explicit SmoothNd(const Parameters& chosen) : parameters(chosen) {}
  reactive::Decision decide(const reactive::Sectors& sectors, const reactive::Point& target);

  Parameters parameters;

 private:
  reactive::SearchTurn search_;
};

}  // namespace smooth_nd
