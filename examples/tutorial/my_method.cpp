// Turns to the free direction closest to the goal.
#include <slalom/methods/slalom_method.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace {

constexpr slalom_parameter parameters[] = {
    {"margin", "0", "m", "kept free on each side of the robot"}};

struct MyMethod {
  slalom_robot robot;
  double width;  // m, half of that of the strip that must be free

  double angle(size_t ray) const {
    return robot.aperture * (double(ray) / double(robot.rays - 1) - 0.5);
  }

  // Free distance (m) of the robot in a direction.
  double free(const slalom_observation& seen, double direction) const {
    double nearest = robot.max_range;
    for (size_t i = 0; i < seen.rays; ++i) {
      const double x = seen.ranges[i] * std::cos(angle(i)), y = seen.ranges[i] * std::sin(angle(i));
      const double ahead = x * std::cos(direction) + y * std::sin(direction);
      const double side = y * std::cos(direction) - x * std::sin(direction);
      if (ahead > 0 && std::abs(side) < width) nearest = std::min(nearest, ahead);
    }
    return nearest - width;
  }

  slalom_command step(const slalom_observation& seen) const {
    const double goal = std::atan2(seen.goal_y, seen.goal_x);
    const double needed = std::min(1.0, std::hypot(seen.goal_x, seen.goal_y));
    double best = NAN;
    for (size_t i = 0; i < seen.rays; i += 4) {
      if (std::abs(angle(i) - goal) >= std::abs(best - goal)) continue;
      if (free(seen, angle(i)) >= needed) best = angle(i);
    }
    if (std::isnan(best)) return {0, robot.max_w / 2, 0};
    const double v = std::min(free(seen, 0), robot.max_v) * std::max(0.0, 1 - std::abs(best));
    return {std::max(0.0, v), std::clamp(2 * best, -robot.max_w, robot.max_w), 0};
  }
};

void* create(const slalom_setting* settings, size_t count, const slalom_robot* robot, char*,
             size_t) {
  const double margin = count > 0 ? std::strtod(settings[0].value, nullptr) : 0;
  return new MyMethod{*robot, robot->radius + margin};
}

int reset(void*, const slalom_task*) {
  return 0;  // a method with memory clears it here
}

int step(void* method, const slalom_observation* seen, slalom_command* command) {
  *command = static_cast<MyMethod*>(method)->step(*seen);
  return 0;
}

void destroy(void* method) {
  delete static_cast<MyMethod*>(method);
}

constexpr slalom_method_api api = {
    SLALOM_METHOD_ABI_VERSION, "my_method", parameters, 1, create, reset, step, destroy};

}  // namespace

const slalom_method_api* slalom_method_get_api() {
  return &api;
}
