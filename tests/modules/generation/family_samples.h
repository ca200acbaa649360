// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>
#include <slalom/generation/generator.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>
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

}  // namespace slalom
