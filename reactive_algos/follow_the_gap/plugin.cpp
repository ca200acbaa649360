#include "follow_the_gap.h"

#include <slalom/methods/slalom_method.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>

namespace {

using follow_the_gap::Parameters;
using follow_the_gap::Robot;

struct Instance {
  Parameters parameters;
  Robot robot;
  double control_period = 0.1;  ///< s
  int last_side = 0;
  std::vector<double> ranges;
};

struct Setting {
  const char* key;
  double Parameters::*field;
};

constexpr Setting kSettings[] = {
    {"alpha", &Parameters::alpha},           {"margin", &Parameters::margin},
    {"look_ahead", &Parameters::look_ahead}, {"goal_weight", &Parameters::goal_weight},
    {"turn_gain", &Parameters::turn_gain},   {"turn_in_place", &Parameters::turn_in_place},
};

constexpr slalom_parameter kParameters[] = {
    {"alpha", "1.0", "m", "weight of the gap against the goal, Eq. (8)"},
    {"margin", "0.1", "m", "added to the robot's radius when obstacles are enlarged"},
    {"look_ahead", "2.5", "m", "obstacles beyond this distance do not close gaps"},
    {"goal_weight", "0.6", "-", "penalty of a gap: twice this per radian from the goal"},
    {"turn_gain", "2.0", "1/s", "angular velocity per radian of heading error"},
    {"turn_in_place", "1.0", "rad", "beyond this heading error the robot rotates in place"},
};

/// Applies one setting. Returns false if it is not a number >= 0.
bool apply(const slalom_setting& setting, Parameters& parameters) {
  char* end = nullptr;
  const double value = std::strtod(setting.value, &end);
  if (end == setting.value || *end != '\0' || !(value >= 0) || std::isinf(value)) return false;
  for (const Setting& known : kSettings)
    if (std::strcmp(known.key, setting.key) == 0) parameters.*known.field = value;
  return true;
}

void* create(const slalom_setting* settings, size_t setting_count, const slalom_robot* robot,
             char* error, size_t error_size) {
  auto* instance = new (std::nothrow) Instance;
  if (instance == nullptr) return nullptr;
  for (size_t i = 0; i < setting_count; ++i) {
    if (apply(settings[i], instance->parameters)) continue;
    std::snprintf(error, error_size, "%s = '%s' is invalid; expected a number >= 0",
                  settings[i].key, settings[i].value);
    delete instance;
    return nullptr;
  }
  instance->robot = {robot->radius,      robot->max_v,    robot->max_w,
                     robot->max_accel_v, robot->aperture, robot->max_range};
  return instance;
}

int reset(void* method, const slalom_task* task) {
  static_cast<Instance*>(method)->control_period = task->control_period;
  static_cast<Instance*>(method)->last_side = 0;
  return 0;
}

int step(void* method, const slalom_observation* observation, slalom_command* command) {
  auto& instance = *static_cast<Instance*>(method);
  if (observation->rays == 0) return 1;
  instance.ranges.assign(observation->ranges, observation->ranges + observation->rays);
  const auto wanted =
      follow_the_gap::decide(instance.ranges, observation->goal_x, observation->goal_y,
                             instance.parameters, instance.robot, instance.last_side);
  const auto twist = follow_the_gap::stop_before_turning(wanted, observation->v, instance.robot,
                                                         instance.control_period);
  command->v = twist.v;
  command->w = twist.w;
  return 0;
}

void destroy(void* method) {
  delete static_cast<Instance*>(method);
}

constexpr slalom_method_api kApi = {SLALOM_METHOD_ABI_VERSION,
                                    "follow_the_gap",
                                    kParameters,
                                    sizeof kParameters / sizeof kParameters[0],
                                    create,
                                    reset,
                                    step,
                                    destroy};

}  // namespace

const slalom_method_api* slalom_method_get_api(void) {
  return &kApi;
}
