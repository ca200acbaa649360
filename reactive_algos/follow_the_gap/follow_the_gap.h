#pragma once

#include <cstddef>
#include <vector>

/// Follow-the-Gap: V. Sezer and M. Gokasan, "A novel obstacle avoidance algorithm: Follow the Gap
/// Method", Robotics and Autonomous Systems 60 (2012) 1123-1134. Equation numbers refer to it.
namespace follow_the_gap {

/// Angles in rad, counter-clockwise from the heading; lengths in m; speeds in m/s and rad/s.
struct Parameters {
  double alpha = 1.0;       ///< m: weight of the gap against the goal, Eq. (8)
  double margin = 0.1;      ///< m added to the robot's radius when obstacles are enlarged
  double look_ahead = 2.5;  ///< m: obstacles farther away close no gap
  double goal_weight =
      0.6;  ///< a gap counts as wide as it is, less twice this times its angle from the goal
  double turn_gain = 2.0;      ///< 1/s: w = turn_gain * angle to steer to
  double turn_in_place = 1.0;  ///< rad: beyond this angle the robot turns without driving
};

struct Robot {
  double radius = 0.25, max_v = 1, max_w = 1.5, max_accel_v = 1;
  double aperture = 3.141592653589793;
  double max_range = 8;
};

struct Gap {
  double low = 0, high = 0;  ///< directions that are free for the enlarged robot
  double width() const { return high - low; }
  bool contains(double angle) const { return angle >= low && angle <= high; }
};

struct Speeds {
  double v = 0, w = 0;
};

/// Direction of ray i of `count`.
double ray_angle(std::size_t i, std::size_t count, double aperture);

/// Gaps between obstacles nearer than `horizon`, each enlarged to a circle of `radius` about its
/// point (section 3.1: a ray is closed when it passes such a circle), from right to left.
std::vector<Gap> find_gaps(const std::vector<double>& ranges, double aperture, double radius,
                           double horizon);

/// The gap to take: widest, less 2 goal_weight times its angle from the goal; null if there is
/// none.
const Gap* choose_gap(const std::vector<Gap>& gaps, double goal_angle, double goal_weight);

/// Eq. (8): the mean of gap centre and goal angle, the gap weighing alpha / nearest obstacle; kept
/// in the gap.
double final_heading(const Gap& gap, double goal_angle, double nearest, double alpha);

/// How far (m) a robot of `radius` can drive straight ahead before it touches a scan point.
double free_way_ahead(const std::vector<double>& ranges, double aperture, double max_range,
                      double radius);

/// One decision: goal in the robot frame (x ahead, y left). The side of the last turn on the spot
/// is kept in `last_side` (+1 left, -1 right, 0 none yet), so that it does not change its mind.
Speeds decide(const std::vector<double>& ranges, double goal_x, double goal_y,
              const Parameters& parameters, const Robot& robot, int& last_side);

}  // namespace follow_the_gap
