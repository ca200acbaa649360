// A method in C++ behind the plain C prototype: a potential field that slides along what is near.
#include <slalom/methods/slalom_method.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>

namespace {

struct PotentialField {
  slalom_robot robot;

  slalom_command decide(const slalom_observation& seen) const {
    const double distance = std::hypot(seen.goal_x, seen.goal_y);
    double x = seen.goal_x / distance, y = seen.goal_y / distance;  // pulled by the goal
    for (std::size_t i = 0; i < seen.rays; ++i) {                   // pushed away by what is near
      const double gap = std::max(0.01, seen.ranges[i] - robot.radius);
      if (gap > 1.0) continue;
      const double angle = robot.aperture * (double(i) / double(seen.rays - 1) - 0.5);
      const double push = 0.01 * (1 / gap - 1) * std::min(1.0, distance);
      x -= push * std::cos(angle) + 0.5 * push * std::sin(angle);  // and turned aside, to the left
      y -= push * std::sin(angle) - 0.5 * push * std::cos(angle);
    }
    const double turn = std::atan2(y, x);
    return {robot.max_v * std::clamp(1.2 - 1.5 * std::abs(turn), 0.0, std::min(1.0, distance)),
            std::clamp(2 * turn, -robot.max_w, robot.max_w), 0};
  }
};

// No exception may leave a function of the prototype.
void* create(const slalom_setting*, size_t, const slalom_robot* robot, char* error, size_t size) {
  auto* method = new (std::nothrow) PotentialField{*robot};
  if (method == nullptr) std::snprintf(error, size, "out of memory");
  return method;
}

int reset(void*, const slalom_task*) {
  return 0;
}

int step(void* method, const slalom_observation* seen, slalom_command* command) {
  *command = static_cast<const PotentialField*>(method)->decide(*seen);
  return 0;
}

void destroy(void* method) {
  delete static_cast<PotentialField*>(method);
}

const slalom_method_api api = {
    SLALOM_METHOD_ABI_VERSION, "my_cpp_method", nullptr, 0, create, reset, step, destroy};

}  // namespace

const slalom_method_api* slalom_method_get_api() {
  return &api;
}
