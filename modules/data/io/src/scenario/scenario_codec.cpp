// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"

#include <slalom/core/byte_stream.h>
#include <slalom/io/scenario_list.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/occupancy.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The second version ends with a published path, the third with movers and, after a flag, a
/// published path, the fourth with the heading of the goal and the same, the fifth with the heading
/// of the goal after a flag, people and the same; each is written only if the one before has no
/// place for what there is.
constexpr std::uint8_t kVersion = 1, kVersionWithPath = 2, kVersionWithMovers = 3,
                       kVersionWithGoalHeading = 4, kVersionWithPeople = 5;
constexpr std::size_t kPointSize = 16, kWaypointSize = 24, kMinMoverSize = 25, kMinPersonSize = 57;

void write_point(ByteWriter& out, const TPoint2D& p) {
  out.f64(p.x).f64(p.y);
}

TPoint2D read_point(ByteReader& in) {
  const double x = in.f64();
  return {x, in.f64()};
}

void write_points(ByteWriter& out, const std::vector<TPoint2D>& points) {
  out.u64(points.size());
  for (const TPoint2D& p : points) write_point(out, p);
}

std::vector<TPoint2D> read_points(ByteReader& in) {
  std::vector<TPoint2D> points(in.count(kPointSize));
  for (TPoint2D& p : points) p = read_point(in);
  return points;
}

void write_primitives(ByteWriter& out, const Primitives& primitives) {
  out.u64(primitives.discs.size());
  for (const Disc& disc : primitives.discs) {
    write_point(out, disc.center);
    out.f64(disc.radius);
  }
  out.u64(primitives.polygons.size());
  for (const Polygon& polygon : primitives.polygons) write_points(out, polygon.vertices);
}

Primitives read_primitives(ByteReader& in) {
  Primitives primitives;
  primitives.discs.resize(in.count(kPointSize + 8));
  for (Disc& disc : primitives.discs) {
    disc.center = read_point(in);
    disc.radius = in.f64();
  }
  primitives.polygons.resize(in.count(8));
  for (Polygon& polygon : primitives.polygons) polygon.vertices = read_points(in);
  return primitives;
}

/// Cells as bits, row by row from the bottom, eight per byte.
void write_grid(ByteWriter& out, const mrpt::maps::COccupancyGridMap2D& map) {
  const auto size_x = map.getSizeX(), size_y = map.getSizeY();
  out.u64(size_x).u64(size_y);
  out.f64(map.getXMin()).f64(map.getYMin()).f64(map.getResolution());
  std::uint8_t byte = 0;
  std::size_t bits = 0;
  for (std::size_t y = 0; y < size_y; ++y)
    for (std::size_t x = 0; x < size_x; ++x) {
      const bool occupied = map.getCell(static_cast<int>(x), static_cast<int>(y)) < 0.5F;
      byte = static_cast<std::uint8_t>(byte | (occupied ? 1U : 0U) << (bits % 8));
      if (++bits % 8 == 0) {
        out.u8(byte);
        byte = 0;
      }
    }
  if (bits % 8 != 0) out.u8(byte);
}

mrpt::maps::COccupancyGridMap2D read_grid(ByteReader& in) {
  constexpr std::uint64_t kMaxSide = 1U << 20, kMaxCells = 400'000'000;
  const std::uint64_t size_x = in.u64(), size_y = in.u64();
  const double x_min = in.f64(), y_min = in.f64(), resolution = in.f64();
  if (size_x == 0 || size_y == 0 || size_x > kMaxSide || size_y > kMaxSide ||
      size_x * size_y > kMaxCells || !(resolution > 0) || !std::isfinite(x_min) ||
      !std::isfinite(y_min) || !std::isfinite(resolution))
    throw in.broken("invalid grid size");
  const char* bytes = in.take((size_x * size_y + 7) / 8);
  auto map =
      make_grid_map(static_cast<int>(size_x), static_cast<int>(size_y), resolution, {x_min, y_min});
  for (std::uint64_t i = 0; i < size_x * size_y; ++i) {
    const bool occupied = ((static_cast<unsigned char>(bytes[i / 8]) >> (i % 8)) & 1U) != 0;
    map.setCell(static_cast<int>(i % size_x), static_cast<int>(i / size_x), occupied ? 0.0F : 1.0F);
  }
  return map;
}

void write_point_map(ByteWriter& out, const mrpt::maps::CSimplePointsMap& map) {
  std::vector<TPoint2D> points(map.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    float x = 0, y = 0;
    map.getPoint(i, x, y);
    points[i] = {x, y};
  }
  write_points(out, points);
}

mrpt::maps::CSimplePointsMap read_point_map(ByteReader& in) {
  mrpt::maps::CSimplePointsMap map;
  for (const TPoint2D& p : read_points(in))
    map.insertPointFast(static_cast<float>(p.x), static_cast<float>(p.y), 0);
  map.mark_as_modified();
  return map;
}

void write_published_path(ByteWriter& out, const PublishedPath& path) {
  out.f64(path.field.x_min).f64(path.field.y_min).f64(path.field.x_max).f64(path.field.y_max);
  out.f64(path.cell_size);
  write_points(out, path.points);
}

PublishedPathPtr read_published_path(ByteReader& in) {
  auto path = std::make_shared<PublishedPath>();
  Bounds& field = path->field;
  for (double* limit : {&field.x_min, &field.y_min, &field.x_max, &field.y_max}) *limit = in.f64();
  path->cell_size = in.f64();
  path->points = read_points(in);
  return path;
}

void write_movers(ByteWriter& out, const Movers& movers) {
  out.u64(movers.size());
  for (const Mover& mover : movers) {
    out.text(mover.id).f64(mover.radius).u8(static_cast<std::uint8_t>(mover.after));
    out.u64(mover.waypoints.size());
    for (const Waypoint& w : mover.waypoints) {
      out.f64(w.t);
      write_point(out, w.position);
    }
  }
}

Movers read_movers(ByteReader& in) {
  Movers movers(in.count(kMinMoverSize));
  for (Mover& mover : movers) {
    mover.id = in.text();
    mover.radius = in.f64();
    const std::uint8_t after = in.u8();
    if (after >= enum_names(MoverEnd{}).size())
      throw in.broken("unknown end of a moving obstacle's path");
    mover.after = static_cast<MoverEnd>(after);
    mover.waypoints.resize(in.count(kWaypointSize));
    for (Waypoint& w : mover.waypoints) {
      w.t = in.f64();
      w.position = read_point(in);
    }
  }
  return movers;
}

void write_people(ByteWriter& out, const People& people) {
  out.u64(people.size());
  for (const Person& person : people) {
    out.text(person.id).f64(person.radius).f64(person.speed).f64(person.begin);
    out.u8(static_cast<std::uint8_t>(person.after));
    write_point(out, person.start);
    write_points(out, person.route);
  }
}

People read_people(ByteReader& in) {
  People people(in.count(kMinPersonSize));
  for (Person& person : people) {
    person.id = in.text();
    person.radius = in.f64();
    person.speed = in.f64();
    person.begin = in.f64();
    const std::uint8_t after = in.u8();
    if (after >= enum_names(PersonEnd{}).size())
      throw in.broken("unknown behavior of a person at its goal");
    person.after = static_cast<PersonEnd>(after);
    person.start = read_point(in);
    person.route = read_points(in);
  }
  return people;
}

bool read_flag(ByteReader& in, const std::string& what) {
  const std::uint8_t flag = in.u8();
  if (flag > 1) throw in.broken("invalid flag of " + what);
  return flag == 1;
}

std::uint8_t version_of(const Scenario& scenario) {
  if (!scenario.people().empty()) return kVersionWithPeople;
  if (scenario.goal_heading()) return kVersionWithGoalHeading;
  if (!scenario.movers().empty()) return kVersionWithMovers;
  return scenario.published_path() ? kVersionWithPath : kVersion;
}

Scenario read_content(ByteReader& in) {
  const auto representation = static_cast<Representation>(in.u8());
  const std::string name = in.text();
  Bounds bounds;
  for (double* limit : {&bounds.x_min, &bounds.y_min, &bounds.x_max, &bounds.y_max})
    *limit = in.f64();
  const TPoint2D position = read_point(in);
  const mrpt::math::TPose2D start(position.x, position.y, in.f64());
  const TPoint2D goal = read_point(in);
  switch (representation) {
    case Representation::Continuous:
      return Scenario::continuous(name, bounds, read_primitives(in), start, goal);
    case Representation::Grid:
      return Scenario::grid(name, read_grid(in), start, goal);
    case Representation::Points:
      return Scenario::points(name, bounds, read_point_map(in), start, goal);
  }
  throw in.broken("unknown representation");
}

Scenario read_scenario(ByteReader& in) {
  const std::uint8_t version = in.u8();
  if (version < kVersion || version > kVersionWithPeople) throw in.broken("unsupported version");
  Scenario scenario = read_content(in);
  bool has_path = version == kVersionWithPath;
  if (version == kVersionWithGoalHeading ||
      (version == kVersionWithPeople && read_flag(in, "a goal heading")))
    scenario = scenario.with_goal_heading(in.f64());
  if (version >= kVersionWithMovers) {
    scenario = scenario.with_movers(read_movers(in));
    if (version == kVersionWithPeople) scenario = scenario.with_people(read_people(in));
    has_path = read_flag(in, "a published path");
  }
  return has_path ? scenario.with_published_path(read_published_path(in)) : scenario;
}

}  // namespace

std::string serialize(const Scenario& scenario) {
  ByteWriter out;
  const PublishedPathPtr& path = scenario.published_path();
  out.u8(version_of(scenario));
  out.u8(static_cast<std::uint8_t>(scenario.representation())).text(scenario.name());
  const Bounds& b = scenario.bounds();
  out.f64(b.x_min).f64(b.y_min).f64(b.x_max).f64(b.y_max);
  out.f64(scenario.start().x).f64(scenario.start().y).f64(scenario.start().phi);
  write_point(out, scenario.goal());
  switch (scenario.representation()) {
    case Representation::Continuous:
      write_primitives(out, scenario.primitives());
      break;
    case Representation::Grid:
      write_grid(out, *scenario.grid_map());
      break;
    case Representation::Points:
      write_point_map(out, *scenario.point_map());
      break;
  }
  const std::uint8_t version = version_of(scenario);
  if (version == kVersionWithPeople) out.u8(scenario.goal_heading() ? 1 : 0);
  if (scenario.goal_heading()) out.f64(*scenario.goal_heading());
  if (version >= kVersionWithMovers) {
    write_movers(out, scenario.movers());
    if (version == kVersionWithPeople) write_people(out, scenario.people());
    out.u8(path ? 1 : 0);
  }
  if (path) write_published_path(out, *path);
  return compress(out.take());
}

Scenario deserialize_scenario(const std::string& bytes, const std::string& where) {
  const std::string content = decompress(bytes, where);
  ByteReader in(content, where);
  Scenario scenario = read_scenario(in);
  in.expect_end();
  return scenario;
}

}  // namespace slalom
