// SPDX-License-Identifier: BSD-3-Clause
#include "obstacle_parts.h"

#include <slalom/core/text.h>

#include <cmath>
#include <map>

namespace slalom {
namespace {

constexpr std::size_t kFree = static_cast<std::size_t>(-1);
constexpr int kPointBlock = 32;

std::string at(double x, double y) {
  return " at (" + format_fixed(x, 2) + ", " + format_fixed(y, 2) + ")";
}

mrpt::math::TPoint2D mean_of(const std::vector<mrpt::math::TPoint2D>& points) {
  mrpt::math::TPoint2D sum(0, 0);
  for (const auto& point : points) sum += point;
  return sum * (1.0 / static_cast<double>(points.size()));
}

/// The 8-connected groups of occupied cells, by cell; numbered in the order of their first cell.
class ConnectedGroups {
 public:
  explicit ConnectedGroups(const mrpt::maps::COccupancyGridMap2D& map)
      : map_(map),
        size_x_(static_cast<int>(map.getSizeX())),
        size_y_(static_cast<int>(map.getSizeY())),
        group_of_(std::size_t{map.getSizeX()} * map.getSizeY(), kFree) {
    for (int y = 0; y < size_y_; ++y)
      for (int x = 0; x < size_x_; ++x)
        if (is_new(x, y)) fill(x, y);
  }
  std::vector<std::size_t> take() { return std::move(group_of_); }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_x_) +
           static_cast<std::size_t>(x);
  }
  bool is_new(int x, int y) const {
    return x >= 0 && y >= 0 && x < size_x_ && y < size_y_ && map_.getCell(x, y) < 0.5F &&
           group_of_[index(x, y)] == kFree;
  }
  void fill(int x, int y) {
    group_of_[index(x, y)] = groups_;
    std::vector<std::pair<int, int>> open = {{x, y}};
    while (!open.empty()) {
      const auto [cx, cy] = open.back();
      open.pop_back();
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (is_new(cx + dx, cy + dy)) {
            group_of_[index(cx + dx, cy + dy)] = groups_;
            open.emplace_back(cx + dx, cy + dy);
          }
    }
    ++groups_;
  }

  const mrpt::maps::COccupancyGridMap2D& map_;
  int size_x_, size_y_;
  std::vector<std::size_t> group_of_;
  std::size_t groups_ = 0;
};

/// Numbers blocks in the order in which they are met.
class BlockNumbers {
 public:
  std::size_t number(long x, long y) {
    return numbers_.emplace(std::make_pair(x, y), numbers_.size()).first->second;
  }

 private:
  std::map<std::pair<long, long>, std::size_t> numbers_;
};

}  // namespace

ObstacleParts::ObstacleParts(const Scenario& scenario, int block, double resolution)
    : scenario_(scenario) {
  if (scenario.representation() == Representation::Continuous)
    divide_primitives();
  else if (scenario.representation() == Representation::Grid)
    divide_cells(block);
  else
    divide_points((block > 0 ? block : kPointBlock) * resolution);
  static_parts_ = size();
  for (const Mover& mover : scenario.movers())
    descriptions_.push_back("moving obstacle '" + mover.id + "' of radius " +
                            format_fixed(mover.radius, 2) + " m");
  for (const Person& person : scenario.people())
    descriptions_.push_back("person '" + person.id + "' of radius " +
                            format_fixed(person.radius, 2) + " m");
}

void ObstacleParts::divide_primitives() {
  for (const Disc& disc : scenario_.primitives().discs)
    descriptions_.push_back("disc of radius " + format_fixed(disc.radius, 2) + " m" +
                            at(disc.center.x, disc.center.y));
  for (const Polygon& polygon : scenario_.primitives().polygons) {
    const auto center = mean_of(polygon.vertices);
    descriptions_.push_back("polygon of " + count_text(polygon.vertices.size(), "corner") +
                            at(center.x, center.y));
  }
  for (std::size_t i = 0; i < descriptions_.size(); ++i) part_of_.push_back(i);
}

void ObstacleParts::divide_cells(int block) {
  const auto& map = *scenario_.grid_map();
  if (block == 0) {
    part_of_ = ConnectedGroups(map).take();
  } else {
    BlockNumbers blocks;
    for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y)
      for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x)
        part_of_.push_back(map.getCell(x, y) < 0.5F ? blocks.number(x / block, y / block) : kFree);
  }
  std::vector<std::vector<mrpt::math::TPoint2D>> cells;
  for (std::size_t i = 0; i < part_of_.size(); ++i) {
    if (part_of_[i] == kFree) continue;
    cells.resize(std::max(cells.size(), part_of_[i] + 1));
    cells[part_of_[i]].emplace_back(map.idx2x(static_cast<int>(i % map.getSizeX())),
                                    map.idx2y(static_cast<int>(i / map.getSizeX())));
  }
  for (const auto& group : cells) {
    const auto center = mean_of(group);
    const std::string what = block == 0 ? "group of " : "block of ";
    descriptions_.push_back(what + count_text(group.size(), "cell") + at(center.x, center.y));
  }
}

void ObstacleParts::divide_points(double side) {
  const auto& map = *scenario_.point_map();
  BlockNumbers blocks;
  std::vector<std::vector<mrpt::math::TPoint2D>> points;
  for (std::size_t i = 0; i < map.size(); ++i) {
    float x = 0, y = 0;
    map.getPoint(i, x, y);
    part_of_.push_back(blocks.number(std::lround(std::floor(static_cast<double>(x) / side)),
                                     std::lround(std::floor(static_cast<double>(y) / side))));
    points.resize(std::max(points.size(), part_of_.back() + 1));
    points[part_of_.back()].emplace_back(x, y);
  }
  for (const auto& group : points) {
    const auto center = mean_of(group);
    descriptions_.push_back(count_text(group.size(), "point") + at(center.x, center.y));
  }
}

Scenario ObstacleParts::keep(const std::vector<std::size_t>& parts) const {
  std::vector<bool> kept(size(), false);
  for (const std::size_t part : parts) kept[part] = true;
  const auto is_kept = [&](std::size_t i) { return part_of_[i] != kFree && kept[part_of_[i]]; };
  Movers movers;
  for (std::size_t i = 0; i < scenario_.movers().size(); ++i)
    if (kept[static_parts_ + i]) movers.push_back(scenario_.movers()[i]);
  People people;
  for (std::size_t i = 0; i < scenario_.people().size(); ++i)
    if (kept[static_parts_ + scenario_.movers().size() + i])
      people.push_back(scenario_.people()[i]);
  const auto& name = scenario_.name();
  if (scenario_.representation() == Representation::Continuous) {
    Primitives some;
    const Primitives& all = scenario_.primitives();
    for (std::size_t i = 0; i < part_of_.size(); ++i) {
      if (!is_kept(i)) continue;
      if (i < all.discs.size())
        some.discs.push_back(all.discs[i]);
      else
        some.polygons.push_back(all.polygons[i - all.discs.size()]);
    }
    return Scenario::continuous(name, scenario_.bounds(), std::move(some), scenario_.start(),
                                scenario_.goal())
        .with_movers(std::move(movers))
        .with_people(std::move(people))
        .with_goal_heading(scenario_.goal_heading());
  }
  if (scenario_.representation() == Representation::Grid) {
    mrpt::maps::COccupancyGridMap2D map = *scenario_.grid_map();
    const int size_x = static_cast<int>(map.getSizeX());
    for (std::size_t i = 0; i < part_of_.size(); ++i)
      if (part_of_[i] != kFree && !is_kept(i))
        map.setCell(static_cast<int>(i) % size_x, static_cast<int>(i) / size_x, 1.0F);
    return Scenario::grid(name, map, scenario_.start(), scenario_.goal())
        .with_movers(std::move(movers))
        .with_people(std::move(people))
        .with_goal_heading(scenario_.goal_heading());
  }
  mrpt::maps::CSimplePointsMap some;
  for (std::size_t i = 0; i < part_of_.size(); ++i) {
    if (!is_kept(i)) continue;
    float x = 0, y = 0;
    scenario_.point_map()->getPoint(i, x, y);
    some.insertPoint(x, y);
  }
  return Scenario::points(name, scenario_.bounds(), some, scenario_.start(), scenario_.goal())
      .with_movers(std::move(movers))
      .with_people(std::move(people))
      .with_goal_heading(scenario_.goal_heading());
}

Scenario ObstacleParts::without(std::size_t part) const {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < size(); ++i)
    if (i != part) others.push_back(i);
  return keep(others);
}

}  // namespace slalom
