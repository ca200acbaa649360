// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/descriptors/descriptor.h>

#include <cmath>
#include <string>
#include <vector>

namespace slalom {

/// A world of 1 m cells given as text, top row first: '#' occupied, 'S' start, 'G' goal, '.' free.
inline World drawn_world(const std::vector<std::string>& rows) {
  const int size_x = static_cast<int>(rows[0].size()), size_y = static_cast<int>(rows.size());
  mrpt::maps::COccupancyGridMap2D map(0, static_cast<float>(size_x), 0, static_cast<float>(size_y),
                                      1.0F);
  mrpt::math::TPose2D start(0.5, 0.5, 0);
  mrpt::math::TPoint2D goal(size_x - 0.5, size_y - 0.5);
  for (int row = 0; row < size_y; ++row)
    for (int x = 0; x < size_x; ++x) {
      const char c = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(x)];
      const int y = size_y - 1 - row;
      map.setCell(x, y, c == '#' ? 0.0F : 1.0F);
      if (c == 'S') start = {x + 0.5, y + 0.5, 0};
      if (c == 'G') goal = {x + 0.5, y + 0.5};
    }
  return {Scenario::grid("drawn", map, start, goal), 1.0};
}

/// Worlds of 5 x 5 cells.
inline const std::vector<std::string> kEmpty = {".....", ".....", "S...G", ".....", "....."};
inline const std::vector<std::string> kBlocks = {".....", ".#.#.", "S...G", ".#...", "....#"};

inline DescriptorContext context_of(const World& world, double robot_radius = 0.25,
                                    double sensor_range = 8) {
  return {world, Footprint::disc(robot_radius), sensor_range, search_once([] {
            return KnownPath{{}, 0, "no path given"};
          })};
}

/// The same with P* given by its vertices.
inline DescriptorContext context_with_path(const World& world, const Path& path,
                                           double robot_radius = 0.25, double sensor_range = 8) {
  DescriptorContext context = context_of(world, robot_radius, sensor_range);
  const double path_length = length(path);
  context.shortest = search_once([path, path_length] { return KnownPath{path, path_length, ""}; });
  return context;
}

/// Cells: how far the points of traversability are from those of a lattice of 1 m, along each axis.
inline const double kLatticeShift = std::sqrt(5.0) - 2;

/// The coordinates of these points along a side of `size` m from 0, in cells of `cell` m.
inline std::vector<double> lattice_along(int size, double cell) {
  std::vector<double> coordinates;
  for (int i = 0; i < size; ++i)
    for (const double side : {-1, 1}) coordinates.push_back(i + 0.5 + side * kLatticeShift * cell);
  return coordinates;
}

/// The value of a descriptor; NaN with a test failure would hide the reason, so NA throws.
inline double value_of(const std::string& id, const DescriptorContext& context) {
  return descriptor(id).compute(context).number();
}

/// A room of 10 m with random discs, translated by `shift`.
inline Scenario random_room(std::uint64_t seed, int discs,
                            const mrpt::math::TPoint2D& shift = {0, 0}) {
  RandomEngine engine(seed);
  Primitives obstacles;
  for (int i = 0; i < discs; ++i) {
    const double x = uniform_real(engine, 1.5, 8.5), y = uniform_real(engine, 1.5, 8.5);
    obstacles.discs.push_back({{x + shift.x, y + shift.y}, uniform_real(engine, 0.2, 0.6)});
  }
  return Scenario::continuous("room", {shift.x, shift.y, 10 + shift.x, 10 + shift.y}, obstacles,
                              {0.6 + shift.x, 0.6 + shift.y, 0}, {9.4 + shift.x, 9.4 + shift.y});
}

}  // namespace slalom
