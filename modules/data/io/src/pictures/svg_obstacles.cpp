// SPDX-License-Identifier: BSD-3-Clause
#include "svg_obstacles.h"

#include <slalom/scenario/occupancy.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr const char* kFill = "#8a8f98";

std::string primitives_svg(const Primitives& primitives, const SvgFrame& frame) {
  std::string svg;
  for (const Disc& disc : primitives.discs) {
    const auto center = frame.to_pixels(disc.center);
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", center.x, center.y,
                       disc.radius * frame.scale());
  }
  for (const Polygon& polygon : primitives.polygons) {
    svg += "<polygon points=\"";
    for (const auto& vertex : polygon.vertices) {
      const auto p = frame.to_pixels(vertex);
      svg += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
    }
    svg += "\"/>";
  }
  return svg;
}

/// A run of occupied blocks in a row: blocks first .. last - 1.
struct Run {
  int first, last;
  bool operator<(const Run& o) const { return first != o.first ? first < o.first : last < o.last; }
};

/// Occupancy in square blocks of cells, merged into rectangles of equal runs in adjacent rows; only
/// those that the frame shows.
class BlockPicture {
 public:
  /// The lower left corner of the cells is at `corner` (pixels).
  BlockPicture(const Occupancy& cells, const TPoint2D& corner, const SvgFrame& frame)
      : cells_(cells),
        block_(std::max(1, static_cast<int>(1 / (cells.resolution() * frame.scale())))),
        pixels_(cells.resolution() * frame.scale() * block_),
        corner_(corner) {
    const auto between = [this](double from, double to, int size) {
      const double blocks = std::ceil(static_cast<double>(size) / block_);
      return Run{static_cast<int>(std::clamp(std::floor(from / pixels_), 0.0, blocks)),
                 static_cast<int>(std::clamp(std::ceil(to / pixels_), 0.0, blocks))};
    };
    columns_ = between(-corner.x, frame.width() - corner.x, cells.size_x());
    rows_ = between(corner.y - frame.height(), corner.y, cells.size_y());
  }

  /// In integer block coordinates, y upwards, scaled to pixels: compact and exact.
  std::string svg() {
    return fmt::format("<path transform=\"matrix({0} 0 0 -{0} {1} {2})\" d=\"{3}\"/>", pixels_,
                       corner_.x, corner_.y, path());
  }

 private:
  std::string path() {
    std::map<Run, int> open;  // runs that extend to this row, with their first row
    for (int row = rows_.first; row <= rows_.last; ++row) {
      const std::vector<Run> runs = row < rows_.last ? runs_of(row) : std::vector<Run>();
      std::map<Run, int> next;
      for (const Run& run : runs) {
        const auto found = open.find(run);
        next[run] = found == open.end() ? row : found->second;
      }
      for (const auto& [run, begin] : open)
        if (next.count(run) == 0 || next[run] != begin) draw(run, begin, row);
      open = std::move(next);
    }
    return path_;
  }

  bool block_occupied(int bx, int by) const {
    for (int cy = by * block_; cy < std::min((by + 1) * block_, cells_.size_y()); ++cy)
      for (int cx = bx * block_; cx < std::min((bx + 1) * block_, cells_.size_x()); ++cx)
        if (cells_.occupied(cx, cy)) return true;
    return false;
  }

  std::vector<Run> runs_of(int row) const {
    std::vector<Run> runs;
    for (int bx = columns_.first; bx < columns_.last; ++bx) {
      if (!block_occupied(bx, row)) continue;
      if (!runs.empty() && runs.back().last == bx) {
        ++runs.back().last;
      } else {
        runs.push_back({bx, bx + 1});
      }
    }
    return runs;
  }

  void draw(const Run& run, int begin, int end) {
    const int width = run.last - run.first;
    path_ += fmt::format("M{} {}h{}v{}h{}z", run.first, begin, width, end - begin, -width);
  }

  const Occupancy& cells_;
  int block_;
  double pixels_;
  TPoint2D corner_;
  Run columns_{}, rows_{};  ///< blocks that are shown
  std::string path_;
};

std::string points_svg(const Scenario& scenario, const SvgFrame& frame) {
  std::string svg;
  const auto& map = *scenario.point_map();
  for (std::size_t i = 0; i < map.size(); ++i) {
    float x = 0, y = 0;
    map.getPoint(i, x, y);
    const auto p = frame.to_pixels({x, y});
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1\"/>", p.x, p.y);
  }
  return svg;
}

}  // namespace

std::string obstacles_svg(const Scenario& scenario, const SvgFrame& frame) {
  std::string shapes;
  switch (scenario.representation()) {
    case Representation::Continuous:
      shapes = primitives_svg(scenario.primitives(), frame);
      break;
    case Representation::Grid:
      shapes =
          BlockPicture(make_occupancy(scenario, 1),
                       frame.to_pixels({scenario.bounds().x_min, scenario.bounds().y_min}), frame)
              .svg();
      break;
    case Representation::Points:
      shapes = points_svg(scenario, frame);
      break;
  }
  return std::string("<g class=\"obstacles\" fill=\"") + kFill + "\">" + shapes + "</g>";
}

std::vector<DrawnMover> drawn_movers(const Scenario& scenario, const SceneOptions& options) {
  std::vector<DrawnMover> drawn;
  const Movers& movers = options.movers != nullptr ? *options.movers : scenario.movers();
  for (const Mover& mover : movers) {
    Path path;
    for (const Waypoint& waypoint : mover.waypoints) path.push_back(waypoint.position);
    drawn.push_back({drawn.size() >= scenario.movers().size(), mover, std::move(path)});
  }
  if (options.movers != nullptr) return drawn;
  for (const Person& person : scenario.people()) {
    Path route = stations_of(person);
    const double t = options.time ? std::numeric_limits<double>::infinity() : person.begin;
    drawn.push_back({true, {person.id, person.radius, {{t, person.start}}}, std::move(route)});
  }
  return drawn;
}

}  // namespace slalom
