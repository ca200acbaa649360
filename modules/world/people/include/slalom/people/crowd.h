// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/people/cost_to_go_field.h>
#include <slalom/people/hindrance.h>
#include <slalom/people/neighborhood.h>
#include <slalom/people/wall_runs.h>
#include <slalom/scenario/person.h>
#include <slalom/scenario/world.h>

#include <memory>
#include <optional>
#include <vector>

namespace slalom {

/// Throws Error (File) naming the scenario of `world` and the person when one starts in a wall, and
/// as check_people() of a name.
void check_people(const World& world, const People& people);

/// The robot among people.
struct RobotDisc {
  CrowdDisc disc;
  std::vector<bool> noticed;  ///< per person
};

/// The state of a person.
struct PersonState {
  CrowdDisc disc;
  bool is_present = false;
  std::optional<double> arrival;        ///< s, the first one at its goal
  std::optional<double> departure;      ///< s, when it vanished
  mrpt::math::TPoint2D wanted, chosen;  ///< m/s, at this update
  Hindrance hindrance;                  ///< up to this update, each counted for its whole period
};

/// People who react to each other, to walls and to those parts of a robot's motion that they
/// notice. A run is a sequence of updates: decide(), move(). Between two updates, a period apart,
/// all walk straight. Nobody enters a wall. Nobody touches another one if people keep apart. Among
/// people who notice the robot, each contact is the robot's doing: it crossed the middle between
/// the two as they were at the last update.
class Crowd {
 public:
  /// `world` has to exist as long as the crowd. Throws as check_people().
  Crowd(const World& world, const People& people, const PeopleSettings& settings);

  int updates() const { return updates_; }                            ///< moves so far
  double time() const { return updates_ * settings_.period; }         ///< s
  const std::vector<PersonState>& states() const { return states_; }  ///< in the order of people
  /// m, of its route that a person has covered: by how much the ways to the stations of the route
  /// became shorter, each while it was the next one.
  double covered(std::size_t i) const;

  /// Lets people appear, arrive, vanish and choose their velocities for the next period.
  void decide(const std::optional<RobotDisc>& robot = {});
  void move();  ///< to the next update

 private:
  struct Plan {
    std::vector<mrpt::math::TPoint2D> stations;  ///< start, via points, goal
    std::vector<std::shared_ptr<const CostToGoField>> fields;
    std::size_t next = 1;  ///< station
    bool back = false;
    bool is_beside = false;                   ///< a robot that covers the goal
    double covered = 0;                       ///< m, on the way to earlier stations
    double leg = 0;                           ///< m, to the next station, when it became that
    std::optional<mrpt::math::TPoint2D> aim;  ///< m, on the way to the next station
    int rank = 0;
  };
  /// The motion of a person who is alone.
  struct Intent {
    mrpt::math::TPoint2D target, velocity;  ///< m, m/s
    bool robot_in_reach = false;            ///< it has a part in what the person chooses
  };
  void plan_routes();
  void set_next(std::size_t i, std::size_t station);
  double rest(std::size_t i) const;
  bool is_free(std::size_t i, const std::optional<RobotDisc>& robot) const;
  void advance(std::size_t i, const std::optional<RobotDisc>& robot);
  Intent intent_of(std::size_t i) const;
  bool is_held_up(std::size_t i, const std::optional<RobotDisc>& robot) const;
  mrpt::math::TPoint2D wanted_velocity(std::size_t i, const std::optional<RobotDisc>& robot) const;
  bool sees(const CrowdDisc& self, const CrowdDisc& other, double sight) const;
  void gather_neighbors(std::size_t i, bool apart, const std::optional<RobotDisc>& robot);
  void look_at_walls();
  void look_at(Neighbor neighbor, double sight);
  mrpt::math::TPoint2D choose(std::size_t i, bool apart, const std::optional<RobotDisc>& robot);
  bool would_touch(std::size_t i) const;
  /// Who decided again.
  std::vector<bool> keep_apart(const std::optional<RobotDisc>& robot);
  mrpt::math::TPoint2D choose_without_robot(std::size_t i, bool apart);
  void add_hindrance(std::size_t i, bool apart, const std::optional<RobotDisc>& robot);

  const World& world_;
  People people_;
  PeopleSettings settings_;
  WallRuns walls_;
  std::vector<PersonState> states_;
  std::vector<Plan> plans_;
  std::vector<Intent> intents_;
  std::vector<std::size_t> by_id_;
  Neighborhood around_;  ///< of the person who decides
  int updates_ = 0;
};

}  // namespace slalom
