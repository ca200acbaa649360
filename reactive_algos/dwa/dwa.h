#pragma once

#include "common/local_map.h"
#include "common/motion.h"

#include <vector>

/// Dynamic Window Approach: D. Fox, W. Burgard and S. Thrun, "The Dynamic Window Approach to
/// Collision Avoidance", IEEE Robotics & Automation Magazine 4(1), 1997, 23-33. Equation numbers
/// refer to it. With `guidance` 1 the heading is that of a navigation function: O. Brock and
/// O. Khatib, "High-speed navigation using the global dynamic window approach", ICRA 1999.
namespace dwa {

/// Lengths in m, times in s.
struct Parameters {
  double alpha = 0.8;          ///< weight of the heading, Eq. (13)
  double beta = 0.2;           ///< weight of the free way
  double gamma = 0.3;          ///< weight of the speed
  double margin = 0.05;        ///< added to the robot's radius
  double horizon = 2.0;        ///< a free way of this length is as good as any
  double v_samples = 13;       ///< speeds in the window
  double w_samples = 41;       ///< turning speeds in the window
  double turn_in_place = 1.6;  ///< rad: a way farther aside is turned to without driving
  double memory = 6;           ///< half the side of the local map
  double guidance = 0;         ///< 0: to the goal; 1: along the navigation function of the map
  double look_ahead = 1.5;     ///< with guidance: how far along the way to aim
};

/// One admissible pair of speeds with the three terms of the objective, each in [0, 1].
struct Candidate {
  reactive::Speeds speeds;
  bool admissible = false;
  double heading = 0, clearance = 0, velocity = 0;
};

/// The dynamic window, Eq. (12): speeds that the robot can reach within `period`.
struct Window {
  reactive::Speeds low, high;
};
Window dynamic_window(const reactive::Speeds& now, const reactive::Robot& robot, double period);

/// Eq. (14): whether the robot can stop on its arc before the obstacle `free_way` ahead.
bool can_stop(const reactive::Speeds& speeds, double free_way, const reactive::Robot& robot,
              double period);

/// The heading term: 1 where the robot would face `target`, 0 where it would face away, at the
/// place where it is after a period with these speeds and then braking its turn.
double heading_term(const reactive::Pose& pose, const reactive::Speeds& speeds,
                    const reactive::Point& target, const reactive::Robot& robot, double period);

class Dwa {
 public:
  using Parameters = dwa::Parameters;
  using Settings = reactive::Setting<Parameters>[11];
  static const Settings& settings();

  Dwa(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::Task& task);
  reactive::Speeds step(const reactive::Observation& observation);

 private:
  reactive::Waypoint target(const reactive::Observation& observation);
  void evaluate(const reactive::Observation& observation, const reactive::Point& target,
                double top_speed);
  reactive::Speeds best() const;
  double smoothed(std::size_t v, std::size_t w) const;

  Parameters parameters_;
  reactive::Robot robot_;
  reactive::Task task_;
  reactive::LocalMap map_;
  reactive::Guide guide_;
  reactive::TurnOnTheSpot turn_;
  std::vector<Candidate> candidates_;  ///< rows of equal v
};

}  // namespace dwa
