#pragma once

#include <slalom/generation/ends.h>
#include <slalom/generation/generator.h>

#include <optional>
#include <utility>
#include <vector>

namespace slalom {

/// Section [generator.rooms]: a storey of rooms and corridors with doors between them.
struct RoomsOptions {
  double width = 14, height = 12;  ///< m
  double min_room = 2.5;           ///< m, least side of a room; one of twice that is parted again
  int corridors = 1;               ///< how often parts are divided by a corridor before walls are
  double corridor_width = 1.6;     ///< m, between middles of walls
  double door_width = 1;           ///< m, clear
  double wall = 0.15;              ///< m, thickness
  double extra_doors = 0.2;        ///< share of the walls without need of a door that have one
  EndsOptions ends = {0.45, 6, 0.6};

  void visit(OptionVisitor& v);
};

/// The floor is divided by corridors, then by walls, until rooms are small; doors join all of them.
/// Start and goal anywhere away from the walls.
std::unique_ptr<Generator> make_rooms(const IniFile& ini, const GeneratorContext& context = {});

/// A wall between two rooms, along the line between them.
struct RoomWall {
  int a = 0, b = 0;                                    ///< rooms on either side
  bool vertical = false;                               ///< the line is x = at, otherwise y = at
  double at = 0, low = 0, high = 0;                    ///< m, where it is and from where to where
  std::optional<std::pair<double, double>> door = {};  ///< m, from where to where along the line
};

/// Rooms and corridors without gaps between them, and all walls where they meet.
struct RoomPlan {
  std::vector<Bounds> rooms;
  std::vector<RoomWall> walls;
};

RoomPlan draw_rooms(RandomEngine& engine, const RoomsOptions& options);

}  // namespace slalom
