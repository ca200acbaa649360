// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"
#include "walls.h"

#include <slalom/generation/rooms.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr double kMaxRooms = 3000;

/// Subdivides a workspace into rooms and corridors.
class WorkspaceDivision {
 public:
  WorkspaceDivision(RandomEngine& engine, const RoomsOptions& options)
      : engine_(engine), options_(options) {}

  std::vector<Bounds> rooms() {
    divide({0, 0, options_.width, options_.height}, options_.corridors);
    return std::move(rooms_);
  }

 private:
  void divide(const Bounds& part, int corridors) {
    const bool wide = part.width() >= part.height();
    if (corridors > 0 && divide_by_corridor(part, wide, corridors)) return;
    const double low = wide ? part.x_min : part.y_min, high = wide ? part.x_max : part.y_max;
    if (high - low < 2 * options_.min_room) {
      rooms_.push_back(part);
      return;
    }
    const double at = uniform_real(engine_, low + options_.min_room, high - options_.min_room);
    divide(below(part, wide, at), corridors);
    divide(above(part, wide, at), corridors);
  }

  /// A corridor runs along the longer side.
  bool divide_by_corridor(const Bounds& part, bool wide, int corridors) {
    const double low = wide ? part.y_min : part.x_min, high = wide ? part.y_max : part.x_max;
    const double room = options_.min_room, corridor = options_.corridor_width;
    if (high - low < 2 * room + corridor) return false;
    const double at = uniform_real(engine_, low + room, high - room - corridor);
    rooms_.push_back(below(above(part, !wide, at), !wide, at + corridor));
    divide(below(part, !wide, at), corridors - 1);
    divide(above(part, !wide, at + corridor), corridors - 1);
    return true;
  }

  static Bounds below(Bounds part, bool vertical, double at) {
    (vertical ? part.x_max : part.y_max) = at;
    return part;
  }
  static Bounds above(Bounds part, bool vertical, double at) {
    (vertical ? part.x_min : part.y_min) = at;
    return part;
  }

  RandomEngine& engine_;
  const RoomsOptions& options_;
  std::vector<Bounds> rooms_;
};

std::optional<RoomWall> wall_between(const std::vector<Bounds>& rooms, int i, int j) {
  const Bounds &a = rooms[static_cast<std::size_t>(i)], &b = rooms[static_cast<std::size_t>(j)];
  const double x_low = std::max(a.x_min, b.x_min), x_high = std::min(a.x_max, b.x_max);
  const double y_low = std::max(a.y_min, b.y_min), y_high = std::min(a.y_max, b.y_max);
  if (x_low == x_high && y_low < y_high) return RoomWall{i, j, true, x_low, y_low, y_high};
  if (y_low == y_high && x_low < x_high) return RoomWall{i, j, false, y_low, x_low, x_high};
  return std::nullopt;
}

std::vector<RoomWall> walls_between(const std::vector<Bounds>& rooms) {
  std::vector<RoomWall> walls;
  const int count = static_cast<int>(rooms.size());
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      if (const auto wall = wall_between(rooms, i, j)) walls.push_back(*wall);
  return walls;
}

/// Doors that connect all rooms and some redundant ones, clear of perpendicular walls.
void draw_doors(RandomEngine& engine, const RoomsOptions& options, RoomPlan& plan) {
  std::vector<CellPair> pairs;
  std::vector<RoomWall*> long_enough;
  for (RoomWall& wall : plan.walls) {
    if (wall.high - wall.low < options.door_width + 2 * options.wall) continue;
    pairs.emplace_back(wall.a, wall.b);
    long_enough.push_back(&wall);
  }
  const auto open =
      open_walls(engine, static_cast<int>(plan.rooms.size()), pairs, options.extra_doors);
  for (std::size_t i = 0; i < long_enough.size(); ++i) {
    if (!open[i]) continue;
    RoomWall& wall = *long_enough[i];
    const double low = uniform_real(engine, wall.low + options.wall,
                                    wall.high - options.wall - options.door_width);
    wall.door = {low, low + options.door_width};
  }
}

void add_piece(const RoomWall& wall, double low, double high, double half, Primitives& walls) {
  walls.polygons.push_back(wall.vertical ? rectangle(wall.at - half, low, wall.at + half, high)
                                         : rectangle(low, wall.at - half, high, wall.at + half));
}

Primitives make_walls(const RoomPlan& plan, double thickness) {
  const double half = thickness / 2;
  Primitives walls;
  for (const RoomWall& wall : plan.walls) {
    // Extended by half the thickness at both ends, so that corners are closed.
    const double low = wall.low - half, high = wall.high + half;
    add_piece(wall, low, wall.door ? wall.door->first : high, half, walls);
    if (wall.door) add_piece(wall, wall.door->second, high, half, walls);
  }
  return walls;
}

class RoomsGenerator : public Generator {
 public:
  explicit RoomsGenerator(const RoomsOptions& options) : options_(options) {}

  std::string name() const override { return "rooms"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const Bounds workspace = {0, 0, options_.width, options_.height};
    Primitives walls = make_walls(sample_rooms(engine, options_), options_.wall);
    const StartGoal start_goal =
        sample_start_goal(engine, workspace, options_.start_goal,
                          clearance_filter(walls, options_.start_goal.clear_radius));
    const auto start = start_pose(engine, start_goal);
    return Scenario::continuous(scenario_name, workspace, std::move(walls), start, start_goal.goal);
  }

 private:
  RoomsOptions options_;
};

}  // namespace

RoomPlan sample_rooms(RandomEngine& engine, const RoomsOptions& options) {
  RoomPlan plan;
  plan.rooms = WorkspaceDivision(engine, options).rooms();
  plan.walls = walls_between(plan.rooms);
  draw_doors(engine, options, plan);
  return plan;
}

void RoomsOptions::visit(OptionVisitor& v) {
  v.option("width", width, "m", "width of the workspace", Range::positive());
  v.option("height", height, "m", "height of the workspace", Range::positive());
  v.option("min_room", min_room, "m", "minimum side of a room, between wall centerlines",
           Range::positive());
  v.option("corridors", corridors, "-", "depth of subdivision by corridors", Range::between(0, 10));
  v.option("corridor_width", corridor_width, "m", "width of corridors, between wall centerlines",
           Range::positive());
  v.option("door_width", door_width, "m", "clear width of doors", Range::positive());
  v.option("wall", wall, "m", "thickness of walls", Range::positive());
  v.option("extra_doors", extra_doors, "-", "fraction of the redundant doors that are added",
           Range::between(0, 1));
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const RoomsOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(RoomsOptions::kFamily, context);
  const auto options = checks.scaled(given);
  // Any two parts along one line have in common at least the shorter of their first sides, so a
  // door of this width always fits somewhere.
  const double side =
      options.corridors > 0 ? std::min(options.min_room, options.corridor_width) : options.min_room;
  checks.expect(options.door_width + 2 * options.wall <= side, "door_width",
                "does not fit between the walls of a room or corridor",
                "at most min_room and corridor_width less twice wall");
  const double squares =
      (options.width / options.min_room + 1) * (options.height / options.min_room + 1);
  checks.expect(squares <= kMaxRooms, "min_room", "is too small for the workspace",
                "at most 3000 squares of that side in the workspace");
  checks.expect_start_goal_fit(options.start_goal, options.width, options.height);
  return std::make_unique<RoomsGenerator>(options);
}

}  // namespace slalom
