// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/geometry.h"
#include "common/parameters.h"
#include "common/robot.h"

#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reactive {

/// A moving disc, in the robot frame.
struct Track {
  Point position;
  Point velocity;  ///< m/s over ground
  double radius = 0;
};

/// The static obstacles of a run, on square cells.
struct KnownMap {
  double resolution = 0.05;  ///< m
  Point origin;              ///< lower left corner, odometry frame
  std::size_t size_x = 0, size_y = 0;
  std::vector<std::uint8_t> cells;  ///< row by row upwards; 1 occupied, 0 free
};

/// Input of a method in each control cycle.
struct Observation {
  Pose pose;       ///< odometry frame
  Twist measured;  ///< current velocities
  Point goal;      ///< robot frame
  std::vector<double> ranges;
};

/// Goal and parameters of a run.
struct NavigationTask {
  Point goal;  ///< odometry frame
  double goal_tolerance = 0.2;
  double control_period = 0.1;
  std::uint64_t seed = 0;
};

/// The table of the C prototype for a class `M` with a nested `Parameters`, whose `visit()`
/// declares the options, a constructor from parameters and robot, `reset(task)` and
/// `step(observation)`. Exceptions are converted to error codes.
template <typename M>
class Plugin {
 public:
  static const slalom_method_api* table(const char* name) {
    static const std::vector<Description> descriptions = described_parameters();
    static std::vector<slalom_parameter> parameters;
    if (parameters.empty())
      for (const Description& d : descriptions)
        parameters.push_back({d.key.c_str(), d.text.c_str(), d.unit.c_str(), d.help.c_str()});
    static const slalom_method_api api = {SLALOM_METHOD_ABI_VERSION,
                                          name,
                                          parameters.data(),
                                          parameters.size(),
                                          create,
                                          reset,
                                          step,
                                          destroy};
    return &api;
  }

  /// The table of slalom_method_get_goal_heading_api() for any class.
  static const slalom_goal_heading_api* goal_heading_table() {
    static const slalom_goal_heading_api api = {SLALOM_GOAL_HEADING_ABI_VERSION, set_goal_heading};
    return &api;
  }

  /// The table of slalom_method_get_tracks_api() for a class with `set_tracks(tracks)`.
  static const slalom_tracks_api* tracks_table() {
    static const slalom_tracks_api api = {SLALOM_TRACKS_ABI_VERSION, set_tracks};
    return &api;
  }

  /// The table of slalom_method_get_space_api() with these ranges of parameters.
  static const slalom_space_api* space_table(const std::vector<slalom_range>& given) {
    static const std::vector<slalom_range> ranges = given;
    static const slalom_space_api api = {SLALOM_SPACE_ABI_VERSION, ranges.data(), ranges.size()};
    return &api;
  }

  /// The table of slalom_method_get_parameters_api() for a class with `take_over(before)`, which
  /// goes on with the run of an object that has other parameters.
  static const slalom_parameters_api* parameters_table() {
    static const slalom_parameters_api api = {SLALOM_PARAMETERS_ABI_VERSION, set_parameter};
    return &api;
  }

  /// The table of slalom_method_get_map_api() for a class with `uses_map()` and `set_map(map)`.
  static const slalom_map_api* map_table() {
    static const slalom_map_api api = {SLALOM_MAP_ABI_VERSION, uses_map, set_map};
    return &api;
  }

 private:
  struct Description {
    std::string key, text, unit, help;
  };
  static std::vector<Description> described_parameters() {
    std::vector<Description> result;
    slalom::for_each_option(typename M::Parameters(), [&](const slalom::Option& option) {
      result.push_back({option.key, option.text(), option.unit, option.help});
    });
    return result;
  }

  /// A method, and what it does not know: the heading of a goal.
  struct Instance {
    typename M::Parameters parameters;
    Robot robot;
    std::unique_ptr<M> method;
    NavigationTask task = {};
    std::optional<double> goal_heading = {};  ///< rad, odometry frame

    /// Slows down so that the robot can stop at the goal, and turns there to its heading.
    Twist step(const Observation& observation) {
      const double goal_distance = distance(observation.goal, {});
      if (goal_heading && goal_distance <= task.goal_tolerance) {
        const double error = wrapped(*goal_heading - observation.pose.phi);
        return {0, stopping_angular_velocity(error, robot)};
      }
      Twist twist = method->step(observation);
      const double limit = stopping_speed(goal_distance, robot);
      if (goal_heading && twist.v > limit) twist = {limit, twist.w * limit / twist.v};
      return twist;
    }
  };
  static M& method_of(void* instance) { return *static_cast<Instance*>(instance)->method; }

  static void* create(const slalom_setting* settings, size_t count, const slalom_robot* robot,
                      char* error, size_t error_size) {
    try {
      typename M::Parameters parameters;
      for (size_t i = 0; i < count; ++i)
        reactive::set_parameter(parameters, settings[i].key, settings[i].value);
      const Robot converted = robot_of(*robot);
      return new Instance{parameters, converted, std::make_unique<M>(parameters, converted)};
    } catch (const std::exception& e) {
      std::snprintf(error, error_size, "%s", e.what());
      return nullptr;
    }
  }

  static int reset(void* method, const slalom_task* task) {
    const NavigationTask converted = {
        {task->goal_x, task->goal_y}, task->goal_tolerance, task->control_period, task->seed};
    return guarded([&] {
      auto& instance = *static_cast<Instance*>(method);
      instance.task = converted;
      instance.goal_heading.reset();
      instance.method->reset(converted);
    });
  }

  static int step(void* method, const slalom_observation* input, slalom_command* command) {
    if (input->rays == 0) return 1;
    return guarded([&] {
      Observation observation;
      observation.pose = {input->x, input->y, input->phi};
      observation.measured = {input->v, input->w};
      observation.goal = {input->goal_x, input->goal_y};
      observation.ranges.assign(input->ranges, input->ranges + input->rays);
      const Twist twist = static_cast<Instance*>(method)->step(observation);
      *command = {twist.v, twist.w, 0};
    });
  }

  static int set_tracks(void* method, const slalom_track* tracks, size_t count) {
    return guarded([&] {
      std::vector<Track> converted;
      for (size_t i = 0; i < count; ++i)
        converted.push_back(
            {{tracks[i].x, tracks[i].y}, {tracks[i].vx, tracks[i].vy}, tracks[i].radius});
      method_of(method).set_tracks(std::move(converted));
    });
  }

  static int set_goal_heading(void* method, double heading, double) {
    static_cast<Instance*>(method)->goal_heading = heading;
    return 0;
  }

  /// Maps and what they remember are of the size and resolution with which the run began.
  static int set_parameter(void* method, const char* key, const char* value) {
    for (const std::string fixed : {"memory", "width", "resolution", "map"})
      if (key == fixed) return 1;
    return guarded([&] {
      auto& instance = *static_cast<Instance*>(method);
      typename M::Parameters parameters = instance.parameters;
      reactive::set_parameter(parameters, key, value);
      auto next = std::make_unique<M>(parameters, instance.robot);
      next->take_over(*instance.method);
      instance.method = std::move(next);
      instance.parameters = parameters;
    });
  }

  static int uses_map(const void* method) {
    return static_cast<const Instance*>(method)->method->uses_map() ? 1 : 0;
  }

  static int set_map(void* method, const slalom_map* map) {
    return guarded([&] {
      method_of(method).set_map({map->resolution,
                                 {map->origin_x, map->origin_y},
                                 map->size_x,
                                 map->size_y,
                                 {map->cells, map->cells + map->size_x * map->size_y}});
    });
  }

  static void destroy(void* method) { delete static_cast<Instance*>(method); }

  template <typename Action>
  static int guarded(Action action) {
    try {
      action();
      return 0;
    } catch (...) {
      return 2;
    }
  }
};

}  // namespace reactive
