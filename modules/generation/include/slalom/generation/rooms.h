// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/start_goal.h>

#include <optional>
#include <utility>
#include <vector>

namespace slalom {

/// Section [generator.rooms]: rooms and corridors connected by doors.
struct RoomsOptions {
  static constexpr char kFamily[] = "rooms";
  double width = 14, height = 12;  ///< m
  double min_room = 2.5;           ///< m, minimum side of a room; twice that is subdivided
  int corridors = 1;               ///< depth of subdivision by corridors, before walls
  double corridor_width = 1.6;     ///< m, between wall centerlines
  double door_width = 1;           ///< m, clear width
  double wall = 0.15;              ///< m, thickness
  double extra_doors = 0.2;        ///< fraction of the redundant doors that are added
  StartGoalOptions start_goal = {0.45, 6, 0.6};

  void visit(OptionVisitor& v);
};

/// The workspace is subdivided by corridors, then by walls; doors connect all rooms. Start and goal
/// anywhere clear of the walls.
std::unique_ptr<Generator> make_generator(const RoomsOptions& options,
                                          const GeneratorContext& context = {});

/// A wall between two rooms.
struct RoomWall {
  int a = 0, b = 0;                  ///< indexes of the adjacent rooms
  bool vertical = false;             ///< on the line x = at, otherwise y = at
  double at = 0, low = 0, high = 0;  ///< m, position of and interval along the line
  std::optional<std::pair<double, double>> door = {};  ///< m, interval along the line
};

/// Rooms and corridors that tile the workspace, and all walls between them.
struct RoomPlan {
  std::vector<Bounds> rooms;
  std::vector<RoomWall> walls;
};

RoomPlan sample_rooms(RandomEngine& engine, const RoomsOptions& options);

}  // namespace slalom
