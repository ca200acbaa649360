// A method in C++ with the plain C prototype: a potential field with a tangential component.
#include <slalom/methods/slalom_method.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>

namespace {

struct PotentialField {
  slalom_robot robot;

  slalom_command decide(const slalom_observation& obs) const {
    const double distance = std::hypot(obs.goal_x, obs.goal_y);
    double x = obs.goal_x / distance, y = obs.goal_y / distance;  // attraction of the goal
    for (std::size_t i = 0; i < obs.rays; ++i) {                  // repulsion of near obstacles
      const double gap = std::max(0.01, obs.ranges[i] - robot.radius);
      if (gap > 1.0) continue;
      const double angle = robot.aperture * (double(i) / double(obs.rays - 1) - 0.5);
      const double force = 0.01 * (1 / gap - 1) * std::min(1.0, distance);
      x -= force * std::cos(angle) + 0.5 * force * std::sin(angle);  // plus a tangential force
      y -= force * std::sin(angle) - 0.5 * force * std::cos(angle);
    }
    const double turn = std::atan2(y, x);
    return {robot.max_v * std::clamp(1.2 - 1.5 * std::abs(turn), 0.0, std::min(1.0, distance)),
            std::clamp(2 * turn, -robot.max_w, robot.max_w), 0};
  }
};

// Functions of the prototype must not throw.
void* create(const slalom_setting*, size_t, const slalom_robot* robot, char* error, size_t size) {
  auto* method = new (std::nothrow) PotentialField{*robot};
  if (method == nullptr) std::snprintf(error, size, "out of memory");
  return method;
}

int reset(void*, const slalom_task*) {
  return 0;
}

int step(void* method, const slalom_observation* obs, slalom_command* command) {
  *command = static_cast<const PotentialField*>(method)->decide(*obs);
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
