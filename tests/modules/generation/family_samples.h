// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>
#include <slalom/generation/generator.h>
#include <slalom/scenario/geometry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// A hall of 20 m x 15 m with cells of 0.1 m, centered at the origin, with two inner walls with
/// gaps and an unknown strip on the right.
inline mrpt::maps::COccupancyGridMap2D hall_map(const std::string&) {
  mrpt::maps::COccupancyGridMap2D map(-10, 10, -7.5F, 7.5F, 0.1F);
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 200; ++x) {
      const bool wall = (x == 70 && y > 30) || (x == 140 && y < 120);
      map.setCell(x, y, x >= 190 ? 0.5F : wall ? 0.0F : 1.0F);
    }
  return map;
}

inline GeneratorContext with_hall(double length_scale = 1) {
  GeneratorContext context;
  context.length_scale = length_scale;
  context.load_map = hall_map;
  return context;
}

/// A generator with options "key = value\n..." in addition to the required ones.
inline std::unique_ptr<Generator> family(const std::string& name, const std::string& options = "",
                                         const GeneratorContext& context = with_hall()) {
  const bool needs_map = name == "crop" || name == "clutter";
  const std::string ini =
      "[generator." + name + "]\n" + (needs_map ? "map = hall\n" : "") + options;
  return make_generator(name, IniFile::from_text(ini, "g.ini"), context);
}

/// The message of the usage error for invalid options.
inline std::string refusal(const std::string& name, const std::string& options) {
  try {
    family(name, options);
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_status(), 2);
    return e.what();
  }
  return "no error";
}

/// m or rad, more than errors of rounding.
constexpr double kRoundingError = 1e-9;

inline void expect_within(double value, double low, double high) {
  EXPECT_GE(value, low - kRoundingError);
  EXPECT_LE(value, high + kRoundingError);
}

/// An angle (rad) to either side, with limits in degrees.
inline void expect_angle_within(double angle, double low_deg, double high_deg) {
  expect_within(std::abs(angle) * 180 / M_PI, low_deg, high_deg);
}

/// From the border and the walls, as they are, not as cells.
inline double wall_clearance(const Scenario& scenario, const mrpt::math::TPoint2D& at) {
  const Bounds& b = scenario.bounds();
  double least = std::min({at.x - b.x_min, b.x_max - at.x, at.y - b.y_min, b.y_max - at.y});
  for (const Polygon& wall : scenario.primitives().polygons)
    least = std::min(least, distance(at, wall));
  return least;
}

/// Expects that the default robot has a path in 20 scenarios of the default options, each of which
/// may take this number of draws.
inline void expect_solvable(const std::string& name, int draws) {
  GenerationSettings settings;
  settings.count = 20;
  settings.attempts_per_scenario = draws;
  const auto progress = make_silent_progress();
  EXPECT_EQ(generate_solvable(*family(name), settings, *progress).size(), 20U);
}

/// Expects that these options, which have no range, give distinct scenarios, in which the robot
/// faces along x.
inline void expect_distinct(const std::string& name, const std::string& options) {
  const auto generator = family(name, options);
  RandomEngine engine(4);
  const Scenario one = generator->generate("x", engine), other = generator->generate("x", engine);
  EXPECT_NE(one.hash(), other.hash());
  EXPECT_EQ(one.start().phi, 0);
}

/// Expects that each of these options is refused with a message that contains the text.
inline void expect_refusals(const std::string& name,
                            const std::vector<std::pair<std::string, std::string>>& refused) {
  for (const auto& [options, message] : refused)
    EXPECT_NE(refusal(name, options).find(message), std::string::npos)
        << options << refusal(name, options);
}

}  // namespace slalom
