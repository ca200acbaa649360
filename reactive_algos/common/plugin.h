#pragma once

#include "common/geometry.h"
#include "common/robot.h"
#include "common/settings.h"

#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

namespace reactive {

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

/// The table of the C prototype for a class `M` with a nested `Parameters`, a static
/// `settings()` (an array of Setting<Parameters>), a constructor from parameters and robot,
/// `reset(task)` and `step(observation)`. Exceptions are converted to error codes.
template <typename M>
class Plugin {
 public:
  static const slalom_method_api* table(const char* name) {
    static std::vector<slalom_parameter> parameters = described_parameters();
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
    const NavigationTask converted = {
        {task->goal_x, task->goal_y}, task->goal_tolerance, task->control_period, task->seed};
    return guarded([&] { static_cast<M*>(method)->reset(converted); });
  }

  static int step(void* method, const slalom_observation* input, slalom_command* command) {
    if (input->rays == 0) return 1;
    return guarded([&] {
      Observation observation;
      observation.pose = {input->x, input->y, input->phi};
      observation.measured = {input->v, input->w};
      observation.goal = {input->goal_x, input->goal_y};
      observation.ranges.assign(input->ranges, input->ranges + input->rays);
      const Twist twist = static_cast<M*>(method)->step(observation);
      *command = {twist.v, twist.w, 0};
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
