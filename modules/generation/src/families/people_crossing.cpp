// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"

#include <slalom/core/distance.h>
#include <slalom/generation/people_crossing.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Draws start and goal of a person.
using WaySampler = std::function<StartGoal()>;

/// Draws people who have room where they start and where they end.
class CrossingPeople {
 public:
  CrossingPeople(const CrossingPeopleOptions& options, const StartGoal& robot, double clear_radius,
                 RandomEngine& engine)
      : options_(options), robot_(robot), clear_radius_(clear_radius), engine_(engine) {}

  /// Begins again when somebody has no room left. Throws Error (Job) with the name of the scenario.
  People sample(const std::string& scenario_name, const WaySampler& draw) const {
    constexpr int kAttempts = 100;
    const int count = uniform_int(engine_, options_.min_people, options_.max_people);
    for (int i = 0; i < kAttempts; ++i)
      if (std::optional<People> people = sample(count, draw)) return std::move(*people);
    throw job_error(scenario_name,
                    "no room for the starts and goals of " + std::to_string(count) + " people",
                    "fewer or smaller people, or a smaller gap");
  }

 private:
  std::optional<People> sample(int count, const WaySampler& draw) const {
    People people;
    for (int i = 0; i < count; ++i) {
      Person person;
      person.id = "person_" + std::to_string(i);
      person.radius = uniform_real(engine_, options_.min_radius, options_.max_radius);
      person.speed = uniform_real(engine_, options_.min_speed, options_.max_speed);
      if (!place(person, people, draw)) return std::nullopt;
      people.push_back(std::move(person));
    }
    return people;
  }

  bool place(Person& person, const People& others, const WaySampler& draw) const {
    constexpr int kDraws = 200;
    for (int i = 0; i < kDraws; ++i) {
      const StartGoal way = draw();
      if (!has_room(way.start, person, others) || !has_room(way.goal, person, others)) continue;
      person.start = way.start;
      person.route = {way.goal};
      return true;
    }
    return false;
  }

  bool has_room(const TPoint2D& p, const Person& person, const People& others) const {
    const double clear = person.radius + clear_radius_;
    return distance_between(p, robot_.start) >= clear &&
           distance_between(p, robot_.goal) >= clear &&
           std::all_of(others.begin(), others.end(), [&](const Person& other) {
             const double apart = person.radius + other.radius + options_.gap;
             return distance_between(p, other.start) >= apart &&
                    distance_between(p, other.route.back()) >= apart;
           });
  }

  const CrossingPeopleOptions& options_;
  const StartGoal& robot_;
  double clear_radius_;
  RandomEngine& engine_;
};

class CircleCrossingGenerator : public Generator {
 public:
  explicit CircleCrossingGenerator(const CircleCrossingOptions& options) : options_(options) {}

  std::string name() const override { return CircleCrossingOptions::kFamily; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const StartGoalOptions& start_goal = options_.start_goal;
    const double radius = uniform_real(engine, options_.min_circle, options_.max_circle);
    const double side = 2 * (options_.max_circle + start_goal.margin);
    const TPoint2D center{side / 2, side / 2};
    const auto on_circle = [&] {
      const double angle = uniform_real(engine, -M_PI, M_PI);
      return TPoint2D{math::cos(angle), math::sin(angle)} * radius;
    };
    const TPoint2D from = on_circle();
    const StartGoal ends = {center + from, center - from};
    const auto start = start_pose(engine, ends);
    const CrossingPeople people(options_.people, ends, start_goal.clear_radius, engine);
    const auto draw = [&]() -> StartGoal {
      TPoint2D shifted = on_circle();
      shifted.x += uniform_real(engine, -options_.noise, options_.noise);
      shifted.y += uniform_real(engine, -options_.noise, options_.noise);
      return {center + shifted, center - shifted};
    };
    return Scenario::continuous(scenario_name, {0, 0, side, side}, {}, start, ends.goal)
        .with_people(people.sample(scenario_name, draw));
  }

 private:
  CircleCrossingOptions options_;
};

class SquareCrossingGenerator : public Generator {
 public:
  explicit SquareCrossingGenerator(const SquareCrossingOptions& options) : options_(options) {}

  std::string name() const override { return SquareCrossingOptions::kFamily; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const double margin = options_.start_goal.margin;
    const double side = options_.side + 2 * margin, middle = side / 2;
    const double far = uniform_real(engine, options_.start_goal.min_distance, options_.side);
    const StartGoal ends = {{middle - far / 2, middle}, {middle + far / 2, middle}};
    const auto start = start_pose(engine, ends);
    const Bounds lower = {margin, margin, side - margin, middle},
                 upper = {margin, middle, side - margin, side - margin};
    const CrossingPeople people(options_.people, ends, options_.start_goal.clear_radius, engine);
    const auto draw = [&]() -> StartGoal {
      const bool is_upward = uniform_int(engine, 0, 1) == 0;
      const TPoint2D from = sample_position(engine, is_upward ? lower : upper);
      return {from, sample_position(engine, is_upward ? upper : lower)};
    };
    return Scenario::continuous(scenario_name, {0, 0, side, side}, {}, start, ends.goal)
        .with_people(people.sample(scenario_name, draw));
  }

 private:
  SquareCrossingOptions options_;
};

/// Expects that `room` people have room; `border` (m) is how far they may be outside.
void expect_people_fit(const FamilyChecks& checks, const CrossingPeopleOptions& people, double room,
                       double margin, double border) {
  checks.expect_order("min_people", people.min_people, "max_people", people.max_people);
  checks.expect_order("min_radius", people.min_radius, "max_radius", people.max_radius);
  checks.expect_order("min_speed", people.min_speed, "max_speed", people.max_speed);
  checks.expect(people.max_radius + border + kWallMargin <= margin, "margin",
                "people would touch the border",
                "at least " + format_number(people.max_radius + border + kWallMargin));
  checks.expect(people.max_people <= room, "max_people", "have no room where they start and end",
                "at most " + format_number(std::floor(std::max(room, 0.0))));
}

double place_size(const CrossingPeopleOptions& people) {
  return 2 * people.max_radius + people.gap;
}

}  // namespace

void CrossingPeopleOptions::visit(OptionVisitor& v) {
  v.option("min_people", min_people, "-", "minimum number of people", Range::between(0, 1000));
  v.option("max_people", max_people, "-", "maximum number of people", Range::between(0, 1000));
  v.option("min_radius", min_radius, "m", "minimum radius of a person", Range::positive());
  v.option("max_radius", max_radius, "m", "maximum radius of a person", Range::positive());
  v.option("min_speed", min_speed, "m/s", "minimum preferred speed of a person",
           Range::between(0.01, 100));
  v.option("max_speed", max_speed, "m/s", "maximum preferred speed of a person",
           Range::between(0.01, 100));
  v.option("gap", gap, "m", "minimum gap between people where they start and end",
           Range::at_least(0));
}

void CircleCrossingOptions::visit(OptionVisitor& v) {
  v.option("min_circle", min_circle, "m", "minimum radius of the circle", Range::positive());
  v.option("max_circle", max_circle, "m", "maximum radius of the circle", Range::positive());
  v.option("noise", noise, "m",
           "greatest shift of a person's start off the circle, along x and along y",
           Range::at_least(0));
  people.visit(v);
  start_goal.visit(v);
}

void SquareCrossingOptions::visit(OptionVisitor& v) {
  v.option("side", side, "m", "side of the square in which people start and end",
           Range::positive());
  people.visit(v);
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const CircleCrossingOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(CircleCrossingOptions::kFamily, context);
  const auto options = checks.scaled(given);
  const auto& start_goal = options.start_goal;
  checks.expect_order("min_circle", options.min_circle, "max_circle", options.max_circle);
  checks.expect(2 * options.min_circle >= start_goal.min_distance, "min_distance",
                "start and goal cannot be min_distance apart on the circle",
                "at most twice min_circle");
  // Places drawn on a line one by one fill 0.7476 of it (Renyi 1958); the robot takes two of them.
  constexpr double kFilled = 0.72;
  const double places = kFilled * 2 * M_PI * options.min_circle / place_size(options.people);
  expect_people_fit(checks, options.people, places / 2 - 1, start_goal.margin, options.noise);
  return std::make_unique<CircleCrossingGenerator>(options);
}

std::unique_ptr<Generator> make_generator(const SquareCrossingOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(SquareCrossingOptions::kFamily, context);
  const auto options = checks.scaled(given);
  const auto& start_goal = options.start_goal;
  checks.expect(options.side >= start_goal.min_distance, "min_distance",
                "start and goal cannot be min_distance apart in the square", "at most side");
  // Discs drawn in the plane one by one fill 0.547 of it (Feder 1980); here up to 0.39 of a half.
  const double places = options.side / place_size(options.people);
  expect_people_fit(checks, options.people, places * places / 4, start_goal.margin, 0);
  return std::make_unique<SquareCrossingGenerator>(options);
}

}  // namespace slalom
