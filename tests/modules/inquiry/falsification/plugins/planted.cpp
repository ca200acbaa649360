// SPDX-License-Identifier: BSD-3-Clause
// Follow-the-gap with a planted defect that begins in rare situations, so that tests know what a
// search has to find. Key defect: none, watch, or one of kDefects.
//
// The ten are rare: docs/results/benchmarks.md has their rates in random scenarios, 1.7e-4
// to 3.5e-3. Measured in the random half of a search with the version without defect as the
// witness, seed 1, cells of 5 cm: squeeze 349 fair failures in 6,000 runs, tie 20 in 6,000, crash
// 67 in 800.
#include "follow_the_gap.h"

#include <slalom/methods/slalom_method.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

/// Defects of the method "watch" that would have begun since its last reset, a bit for each in the
/// order of kDefects. Until a defect begins, a method with it equals the one without.
extern "C" SLALOM_METHOD_EXPORT unsigned planted_defects_begun;
unsigned planted_defects_begun = 0;

namespace {

constexpr double kDegree = M_PI / 180;
constexpr int kDefectiveCycles = 12;

/// The memory of a run, and what the defects look at.
struct Planted {
  std::string defect = "none";
  follow_the_gap::Robot robot;
  int last_side = 0;
  int cycles_left = 0;  // of the defective behavior
  slalom_command command = {0, 0, 0};
  std::vector<double> ranges;
  double v = 0, goal_bearing = 0;
  // Memory, which one observation does not show.
  int cycles = 0, beside_wall = 0, reversals = 0;
  double turned = 0, last_w = 0;  // rad in the last turn to one side; rad/s

  /// The smallest range between two directions (degrees).
  double nearest(double from, double to) const {
    double least = robot.max_range;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double angle = follow_the_gap::ray_angle(i, ranges.size(), robot.aperture);
      if (angle >= from * kDegree && angle <= to * kDegree) least = std::min(least, ranges[i]);
    }
    return least;
  }
  double ahead() const { return nearest(-15, 15); }

  void remember(double w) {
    ++cycles;
    beside_wall = std::min(nearest(40, 90), nearest(-90, -40)) < 0.6 ? beside_wall + 1 : 0;
    if (w * last_w < 0) {
      ++reversals;
      turned = 0;
    }
    turned += std::abs(w) * 0.1;
    if (w != 0) last_w = w;
  }
};

/// An obstacle ahead at 0.5 to 0.62 m between two gaps, equally wide within `tolerance`.
bool is_tied(const Planted& self, double tolerance) {
  if (self.ahead() < 0.5 || self.ahead() > 0.62) return false;
  const auto gaps =
      follow_the_gap::find_gaps(self.ranges, self.robot.aperture, self.robot.radius + 0.1, 2.5);
  for (std::size_t i = 0; i + 1 < gaps.size(); ++i)
    if (gaps[i].high < 0 && gaps[i + 1].low > 0 &&
        std::abs(gaps[i].width() - gaps[i + 1].width()) < tolerance * gaps[i].width())
      return true;
  return false;
}

/// Obstacles close by on both sides, equally far within `tolerance` (m).
bool is_squeezed(const Planted& self, double limit, double tolerance) {
  const double left = self.nearest(20, 90), right = self.nearest(-90, -20);
  return left < limit && right < limit && std::abs(left - right) < tolerance;
}

struct Defect {
  const char* name;
  bool has_memory;
  bool (*begins)(const Planted& self);
  double v, w;  // of the defective cycles
};

constexpr Defect kDefects[] = {
    {"tie", false, [](const Planted& p) { return is_tied(p, 0.02); }, 0.6, 0},
    {"fine_tie", false, [](const Planted& p) { return is_tied(p, 0.02) && p.ahead() < 0.53; }, 0.6,
     0},
    {"narrow_squeeze", false, [](const Planted& p) { return is_squeezed(p, 0.45, 0.0005); }, 0.6,
     1.2},
    {"fine_squeeze", false,
     [](const Planted& p) { return is_squeezed(p, 0.37, 0.005) && p.ahead() < 0.9; }, 0.6, 1.2},
    {"fast_and_near", false,
     [](const Planted& p) {
       return p.v > 0.5 && p.nearest(20, 30) < 0.5 && p.nearest(31, 90) > 0.8;
     },
     0.6, 1.2},
    {"goal_behind", false,
     [](const Planted& p) {
       return std::abs(p.goal_bearing - 42 * kDegree) < 0.02 * kDegree && p.nearest(38, 46) < 0.5 &&
              p.ahead() > 2;
     },
     0.6, 1.2},
    {"needle", false,
     [](const Planted& p) {
       return std::abs(p.goal_bearing - 42 * kDegree) < 0.002 * kDegree &&
              p.nearest(38, 46) < 0.5 && p.ahead() > 2;
     },
     0.6, 1.2},
    {"beside_wall", true, [](const Planted& p) { return p.beside_wall >= 60 && p.ahead() < 0.9; },
     0.6, 0},
    {"overflow", true, [](const Planted& p) { return p.reversals >= 32 && p.ahead() < 0.7; }, 0.6,
     0},
    {"after_turn", true,
     [](const Planted& p) { return p.turned > 6 && p.v > 0.3 && p.ahead() < 0.7; }, 0.6, 0},
    {"cycle_128", true, [](const Planted& p) { return p.cycles == 128 && p.ahead() < 0.45; }, 0.6,
     0},
    // Not of the eleven: a frequent one, and the same, which ends the process.
    {"squeeze", false, [](const Planted& p) { return is_squeezed(p, 0.62, 0.04); }, 0.6, 1.2},
    {"crash", false, [](const Planted& p) { return is_squeezed(p, 0.62, 0.04); }, 0, 0},
};

void* create(const slalom_setting* settings, size_t count, const slalom_robot* robot, char* error,
             size_t error_size) {
  auto* self = new Planted;
  if (count > 0) self->defect = settings[0].value;
  if (self->defect != "none" && self->defect != "watch" &&
      std::none_of(std::begin(kDefects), std::end(kDefects),
                   [&](const Defect& known) { return self->defect == known.name; })) {
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
  Planted fresh;
  fresh.defect = self.defect;
  fresh.robot = self.robot;
  self = fresh;
  if (self.defect == "watch") planted_defects_begun = 0;
  return 0;
}

/// The defect that begins in this cycle, or none.
const Defect* find_defect(const Planted& self) {
  const Defect* found = nullptr;
  unsigned bit = 1;
  for (const Defect& defect : kDefects) {
    if (self.defect == defect.name && defect.begins(self)) found = &defect;
    if (self.defect == "watch" && defect.begins(self)) planted_defects_begun |= bit;
    bit <<= 1U;
  }
  return found;
}

int step(void* method, const slalom_observation* seen, slalom_command* command) {
  auto& self = *static_cast<Planted*>(method);
  self.ranges.assign(seen->ranges, seen->ranges + seen->rays);
  self.v = seen->v;
  self.goal_bearing = std::atan2(seen->goal_y, seen->goal_x);
  if (const Defect* begun = find_defect(self)) {
    if (self.defect == "crash") std::abort();
    self.cycles_left = kDefectiveCycles;
    self.command = {begun->v, begun->w, 0};
  }
  if (self.cycles_left > 0) {
    --self.cycles_left;
    *command = self.command;
  } else {
    const follow_the_gap::Twist twist = follow_the_gap::decide(
        self.ranges, seen->goal_x, seen->goal_y, {}, self.robot, self.last_side);
    *command = {twist.v, twist.w, 0};
  }
  self.remember(command->w);
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
