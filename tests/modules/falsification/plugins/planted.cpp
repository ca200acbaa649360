// Follow-the-gap with a planted defect that begins in rare situations, so that tests know what a
// search has to find. Key defect: none, squeeze, tie or crash.
//
// Measured in the random half of a search with the version without defect as the witness, seed 1,
// cells of 5 cm: squeeze 349 fair failures in 6,000 runs, tie 20 in 6,000, crash 67 in 800.
#include "follow_the_gap.h"

#include <slalom/methods/slalom_method.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

constexpr double kDegree = M_PI / 180;
constexpr int kDefectiveCycles = 12;

struct Planted {
  std::string defect = "none";
  follow_the_gap::Robot robot;
  int last_side = 0;
  int cycles_left = 0;  // of the defective behavior
  std::vector<double> ranges;

  /// The smallest range between two directions (rad).
  double nearest(double from, double to) const {
    double least = robot.max_range;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double angle = follow_the_gap::ray_angle(i, ranges.size(), robot.aperture);
      if (angle >= from && angle <= to) least = std::min(least, ranges[i]);
    }
    return least;
  }

  /// Obstacles close by on both sides, equally far within 4 cm.
  bool in_squeeze() const {
    const double left = nearest(20 * kDegree, 90 * kDegree);
    const double right = nearest(-90 * kDegree, -20 * kDegree);
    return left < 0.62 && right < 0.62 && std::abs(left - right) < 0.04;
  }

  /// An obstacle ahead at 0.5 to 0.62 m between two gaps, equally wide within 2 %.
  bool in_tie() const {
    const double ahead = nearest(-15 * kDegree, 15 * kDegree);
    if (ahead < 0.5 || ahead > 0.62) return false;
    const auto gaps = follow_the_gap::find_gaps(ranges, robot.aperture, robot.radius + 0.1, 2.5);
    for (std::size_t i = 0; i + 1 < gaps.size(); ++i)
      if (gaps[i].high < 0 && gaps[i + 1].low > 0 &&
          std::abs(gaps[i].width() - gaps[i + 1].width()) < 0.02 * gaps[i].width())
        return true;
    return false;
  }
};

void* create(const slalom_setting* settings, size_t count, const slalom_robot* robot, char* error,
             size_t error_size) {
  auto* self = new Planted;
  if (count > 0) self->defect = settings[0].value;
  const char* known[] = {"none", "squeeze", "tie", "crash"};
  if (std::find(std::begin(known), std::end(known), self->defect) == std::end(known)) {
    std::snprintf(error, error_size, "unknown defect '%s'", self->defect.c_str());
    delete self;
    return nullptr;
  }
  self->robot = {robot->radius,      robot->max_v,    robot->max_w,
                 robot->max_accel_v, robot->aperture, robot->max_range};
  return self;
}

int reset(void* method, const slalom_task*) {
  auto& self = *static_cast<Planted*>(method);
  self.last_side = self.cycles_left = 0;
  return 0;
}

int step(void* method, const slalom_observation* seen, slalom_command* command) {
  auto& self = *static_cast<Planted*>(method);
  self.ranges.assign(seen->ranges, seen->ranges + seen->rays);
  const bool squeezes = self.defect == "squeeze" || self.defect == "crash";
  if ((squeezes && self.in_squeeze()) || (self.defect == "tie" && self.in_tie())) {
    if (self.defect == "crash") std::abort();
    self.cycles_left = kDefectiveCycles;
  }
  if (self.cycles_left > 0) {
    --self.cycles_left;
    *command = {0.6, self.defect == "squeeze" ? 1.2 : 0, 0};
    return 0;
  }
  const follow_the_gap::Twist twist = follow_the_gap::decide(
      self.ranges, seen->goal_x, seen->goal_y, {}, self.robot, self.last_side);
  *command = {twist.v, twist.w, 0};
  return 0;
}

void destroy(void* method) {
  delete static_cast<Planted*>(method);
}

constexpr slalom_parameter kParameters[] = {{"defect", "none", "-", "the planted defect"}};
constexpr slalom_method_api kApi = {
    SLALOM_METHOD_ABI_VERSION, "planted", kParameters, 1, create, reset, step, destroy};

}  // namespace

const slalom_method_api* slalom_method_get_api(void) {
  return &kApi;
}
