// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/generation/moving.h>
#include <slalom/generation/sample_people.h>
#include <slalom/generation/start_goal.h>
#include <slalom/references/disc_path.h>

#include <algorithm>
#include <string>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kRobotMargin = 1, kMinWay = 3;  // m

bool has_way(const World& world, double radius, const TPoint2D& from, const TPoint2D& to) {
  std::string reason;
  return shortest_disc_path(world.occupancy(), radius, from, to, reason).has_value();
}

/// Draws starts and goals with room for a person.
class PlaceSampler {
 public:
  PlaceSampler(const World& world, double robot_radius, const People& others, RandomEngine& engine)
      : world_(world), robot_radius_(robot_radius), others_(others), engine_(engine) {}

  /// Sets start and goal; false if none are found.
  bool place(Person& person) const {
    constexpr int kDraws = 200;
    const auto& scenario = world_.scenario();
    for (int i = 0; i < kDraws; ++i) {
      person.start = sample_position(engine_, scenario.bounds());
      const TPoint2D goal = sample_position(engine_, scenario.bounds());
      const auto start_of = [](const Person& other) { return other.start; };
      const auto goal_of = [](const Person& other) { return other.route.back(); };
      if (distance_between(person.start, goal) >= kMinWay &&
          has_room(person.start, person.radius, TPoint2D(scenario.start()), start_of) &&
          has_room(goal, person.radius, scenario.goal(), goal_of) &&
          has_way(world_, person.radius + kWallMargin, person.start, goal)) {
        person.route = {goal};
        return true;
      }
    }
    return false;
  }

 private:
  template <typename PlaceOf>
  bool has_room(const TPoint2D& p, double radius, const TPoint2D& robot, PlaceOf place_of) const {
    return world_.distance_field().clearance(p) >= radius + kWallMargin &&
           distance_between(p, robot) >= radius + robot_radius_ + kRobotMargin &&
           std::all_of(others_.begin(), others_.end(), [&](const Person& other) {
             return distance_between(p, place_of(other)) >= radius + other.radius + kWallMargin;
           });
  }

  const World& world_;
  double robot_radius_;
  const People& others_;
  RandomEngine& engine_;
};

}  // namespace

People sample_people(const World& world, double robot_radius, const PeopleOptions& options,
                     RandomEngine& engine) {
  People people = world.scenario().people();
  for (int i = 0; i < options.count; ++i) {
    Person person;
    person.id = "person_" + std::to_string(people.size());
    person.radius = uniform_real(engine, options.min_radius, options.max_radius);
    person.speed = uniform_real(engine, options.min_speed, options.max_speed);
    person.after = PersonEnd::Return;
    if (!PlaceSampler(world, robot_radius, people, engine).place(person))
      throw job_error(world.scenario().name(),
                      "no room for a person of radius " + format_fixed(person.radius, 2) + " m",
                      "fewer or smaller people, or fewer obstacles");
    people.push_back(std::move(person));
  }
  return people;
}

std::string problem_of_people(const World& world, double robot_radius) {
  for (const Person& person : world.scenario().people()) {
    const std::string who = "person '" + person.id + "' ";
    if (world.distance_field().clearance(person.start) < person.radius)
      return who + "starts in a wall";
    const bool is_there = person.begin <= 0;
    if (is_there &&
        distance_between(person.start, world.scenario().start()) < person.radius + robot_radius)
      return who + "touches the robot at the start";
    TPoint2D from = person.start;
    for (const TPoint2D& to : person.route) {
      if (!has_way(world, person.radius, from, to)) return who + "has no way to its goal";
      from = to;
    }
  }
  return "";
}

}  // namespace slalom
