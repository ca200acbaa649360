// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/parameters.h"
#include "common/valleys.h"

/// ND+: J. Minguez, J. Osuna and L. Montano, "A Divide and Conquer Strategy based on Situations to
/// achieve Reactive Collision Avoidance in Troublesome Scenarios", ICRA 2004, 3855-3862; with
/// J. Minguez and L. Montano, "Nearness Diagram (ND) Navigation: Collision Avoidance in Troublesome
/// Scenarios", IEEE Transactions on Robotics and Automation 20(1), 2004, 45-59, for the five
/// situations that both share. Six situations, each with its own motion law.
namespace nd_plus {

/// Lengths in the unit of the sectors: with the adapter mrpt_holonomic, reference distances.
struct Parameters {
  double safety_distance = 0.12;   ///< D_s of the safety zone
  double gap = 0.2;                ///< minimum discontinuity of the free distance at a gap
  double passable = 0.15;          ///< sectors with a smaller free distance are closed
  double wide_valley = 0.9;        ///< rad, s_max: valleys wider than this are wide
  double field_of_view = 3.1416;   ///< rad: valleys outside it are ignored
  double slow_distance = 0.3;      ///< below this free distance the robot slows down
  double target_slow_down = 0.45;  ///< m: below this distance to the target the robot slows down

  void visit(slalom::OptionVisitor& v);
};

/// High safety: goal in region, wide region, narrow region. Low safety: goal in region, obstacles
/// on one side, obstacles on both sides.
enum class Situation { Hsgr, Hswr, Hsnr, Lsgr, Ls1, Ls2 };

/// The nearest obstacle within the safety zone to the left and to the right of a direction.
struct Threats {
  double left_distance = 0, left_direction = 0;  ///< valid if `left`
  double right_distance = 0, right_direction = 0;
  bool left = false, right = false;
};
Threats find_threats(const reactive::Sectors& sectors, double direction, double safety_distance);

/// The decision tree: safety, side(s) of the threats, goal in region, width of the region.
Situation situation(const Threats& threats, bool goal_in_region, double width, double wide_valley);

class NdPlus {
 public:
  using Parameters = nd_plus::Parameters;

  NdPlus() = default;
  explicit NdPlus(const Parameters& chosen) : parameters(chosen) {}
  reactive::Decision decide(const reactive::Sectors& sectors, const reactive::Point& target);

  Parameters parameters;

 private:
  double turn_away(const Threats& threats, double direction) const;
  double balance_threats(const Threats& threats, double direction) const;

  reactive::SearchTurn search_;
};

}  // namespace nd_plus
