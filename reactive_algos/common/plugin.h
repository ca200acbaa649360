#pragma once

#include "common/geometry.h"
#include "common/robot.h"
#include "common/settings.h"

#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

namespace reactive {

/// What a method is given in each control cycle.
struct Observation {
  Pose pose;        ///< odometry frame
  Speeds measured;  ///< speeds now
  Point goal;       ///< robot frame
  std::vector<double> ranges;
};

/// What a run is about.
struct Task {
  Point goal;  ///< odometry frame
  double goal_tolerance = 0.2;
  double control_period = 0.1;
  std::uint64_t seed = 0;
};

/// The table of the C prototype for a class `M` with a nested `Parameters`, a static
/// `settings()` (an array of Setting<Parameters>), a constructor from parameters and robot,
/// `reset(task)` and `step(observation)`. No exception leaves it: they become error codes.
template <typename M>
class Plugin {
 public:
  static const slalom_method_api* table(const char* name) {
    static std::vector<slalom_parameter> described = described_parameters();
    static const slalom_method_api api = {SLALOM_METHOD_ABI_VERSION,
                                          name,
                                          described.data(),
                                          described.size(),
                                          create,
                                          reset,
                                          step,
                                          destroy};
    return &api;
  }

 private:
  static std::vector<slalom_parameter> described_parameters() {
    std::vector<slalom_parameter> result;
    for (const auto& setting : M::settings()) result.push_back(setting.about);
    return result;
  }

  static void* create(const slalom_setting* settings, size_t count, const slalom_robot* robot,
                      char* error, size_t error_size) {
    typename M::Parameters parameters;
    for (size_t i = 0; i < count; ++i)
      if (!apply(M::settings(), settings[i].key, settings[i].value, parameters, error, error_size))
        return nullptr;
    try {
      return new M(parameters, robot_of(*robot));
    } catch (const std::exception& e) {
      std::snprintf(error, error_size, "%s", e.what());
      return nullptr;
    }
  }

  static int reset(void* method, const slalom_task* task) {
    const Task converted = {
        {task->goal_x, task->goal_y}, task->goal_tolerance, task->control_period, task->seed};
    return guarded([&] { static_cast<M*>(method)->reset(converted); });
  }

  static int step(void* method, const slalom_observation* seen, slalom_command* command) {
    if (seen->rays == 0) return 1;
    return guarded([&] {
      Observation observation;
      observation.pose = {seen->x, seen->y, seen->phi};
      observation.measured = {seen->v, seen->w};
      observation.goal = {seen->goal_x, seen->goal_y};
      observation.ranges.assign(seen->ranges, seen->ranges + seen->rays);
      const Speeds speeds = static_cast<M*>(method)->step(observation);
      *command = {speeds.v, speeds.w, 0};
    });
  }

  static void destroy(void* method) { delete static_cast<M*>(method); }

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
