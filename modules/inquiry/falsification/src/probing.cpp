// SPDX-License-Identifier: BSD-3-Clause
#include "probing.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/pose.h>
#include <slalom/generation/start_goal.h>
#include <slalom/simulation/range_finder.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr int kProbes = 1000;  // drawn in one world, of which about 200 are near obstacles

bool are_same(const Command& a, const Command& b) {
  constexpr double kTolerance = 1e-9;
  return std::abs(a.v - b.v) <= kTolerance && std::abs(a.w - b.w) <= kTolerance &&
         std::abs(a.vy - b.vy) <= kTolerance;
}

/// A method; another one gets the same observations until its command is a different one.
class ShadowRun : public Method {
 public:
  ShadowRun(Method& method, Method& shadow) : method_(method), shadow_(shadow) {}
  void reset(const NavigationTask& task) override {
    method_.reset(task);
    compare([&] {
      shadow_.reset(task);
      return true;
    });
  }
  void settle(const Observation& start) override {
    method_.settle(start);
    if (!differs_)
      compare([&] {
        shadow_.settle(start);
        return true;
      });
  }
  Command step(const Observation& observation) override {
    const Command command = method_.step(observation);
    if (!differs_) compare([&] { return are_same(command, shadow_.step(observation)); });
    return command;
  }
  bool uses_tracks() const override { return method_.uses_tracks() || shadow_.uses_tracks(); }
  bool uses_map() const override { return method_.uses_map() || shadow_.uses_map(); }
  bool is_paced() const override { return method_.is_paced(); }
  bool differs() const { return differs_; }

 private:
  template <typename Same>
  void compare(Same same) {
    try {
      differs_ = !same();
    } catch (const std::exception&) {
      differs_ = true;  // a run shows whether it is the method that fails
    }
  }

  Method& method_;
  Method& shadow_;
  bool differs_ = false;
};

/// The movers, and people where they start: probes are at time 0.
Movers present_at_start(const Scenario& scenario) {
  Movers present = scenario.movers();
  for (const Person& person : scenario.people())
    present.push_back({person.id, person.radius, {{person.begin, person.start}}});
  return present;
}

}  // namespace

bool StepProbe::draw(const World& world, RandomEngine& engine, CommandDifference& probe) const {
  constexpr double kNear = 0.9, kStartFree = 0.03, kGoalFree = 0.1;  // m
  const double radius = setup_.run.robot.shape().enclosing_radius();
  const TPoint2D at = sample_position(engine, world.scenario().bounds());
  const double heading = uniform_real(engine, -M_PI, M_PI);
  const double bearing = heading + uniform_real(engine, -2, 2);
  const double distance = uniform_real(engine, 1, 5);
  probe.pose = {at.x, at.y, heading};
  probe.goal = at + TPoint2D(math::cos(bearing), math::sin(bearing)) * distance;
  const double clearance = world.distance_field().clearance(at);
  return clearance >= radius + kStartFree && clearance <= kNear + radius &&
         world.scenario().bounds().contains(probe.goal) &&
         world.distance_field().clearance(probe.goal) > radius + kGoalFree;
}

Command StepProbe::command(std::size_t index, const CommandDifference& probe,
                           const Observation& observation) {
  Method& method = methods_.method(index);
  const SimulationOptions& simulation = setup_.run.simulation;
  method.reset(
      {probe.pose, probe.goal, simulation.goal_tolerance, simulation.control_period, setup_.seed});
  method.settle(observation);
  return method.step(observation);
}

std::optional<CommandDifference> StepProbe::find_in_run(const std::shared_ptr<const World>& world) {
  ShadowRun both(methods_.method(1), methods_.method(0));
  run_trial(*world, setup_, both);
  const Scenario& scenario = world->scenario();
  if (!both.differs()) return std::nullopt;
  return CommandDifference{world, scenario.start(), scenario.goal(), true};
}

std::optional<CommandDifference> StepProbe::find_in_steps(const std::shared_ptr<const World>& world,
                                                          RandomEngine& engine) {
  const auto is_privileged = [&](std::size_t i) {
    return methods_.method(i).uses_tracks() || methods_.method(i).uses_map();
  };
  if (is_privileged(0) || is_privileged(1)) return std::nullopt;
  const Movers present = present_at_start(world->scenario());
  RangeFinder sensor(*world, present, setup_.run.sensor, setup_.seed);
  CommandDifference probe{world, {}, {}};
  for (int i = 0; i < kProbes; ++i) {
    const bool is_near = draw(*world, engine, probe);
    Observation observation;
    observation.odometry = probe.pose;
    observation.v = uniform_real(engine, 0, setup_.run.robot.max_v);
    observation.goal_in_robot = inverse_compose(probe.pose, probe.goal);
    if (!is_near) continue;
    sensor.sense(probe.pose, 0, mrpt::Clock::time_point(), observation);
    try {
      if (!are_same(command(0, probe, observation), command(1, probe, observation))) return probe;
    } catch (const std::exception&) {
      return probe;  // a run shows whether it is the method that fails
    }
  }
  return std::nullopt;
}

std::unique_ptr<World> approach(const CommandDifference& difference,
                                const FalsificationSetup& setup, const FairnessOptions& fairness,
                                int number, RandomEngine& engine) {
  constexpr int kMaxAttempts = 30;
  constexpr int kExact = 5;  // of the first ones
  const TPose2D& pose = difference.pose;
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    const bool is_here = number == 1 && attempt == 0, is_exact = number <= kExact;
    const double drawn = uniform_real(engine, 0.1, 1.2), back = is_here ? 0 : drawn;
    const double turn = normal(engine, 0, 0.1), shift = normal(engine, 0, 0.03);
    const double aside = is_exact ? 0 : shift;
    const TPose2D start(pose.x - math::cos(pose.phi) * back - math::sin(pose.phi) * aside,
                        pose.y - math::sin(pose.phi) * back + math::cos(pose.phi) * aside,
                        pose.phi + (is_exact ? 0 : turn));
    if (!difference.world->scenario().bounds().contains({start.x, start.y})) continue;
    auto world = std::make_unique<World>(
        difference.world->scenario().with_start_goal(start, difference.goal),
        setup.run.simulation.resolution);
    if (has_fair_geometry(*world, setup.run.robot, fairness)) return world;
  }
  return nullptr;
}

}  // namespace slalom
