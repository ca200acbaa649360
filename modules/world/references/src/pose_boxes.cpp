// SPDX-License-Identifier: BSD-3-Clause
#include "pose_boxes.h"

#include <slalom/core/geometry.h>
#include <slalom/core/math.h>
#include <slalom/references/footprint_path.h>
#include <slalom/scenario/geometry.h>

#include <mrpt/math/TPolygon2D.h>
#include <mrpt/math/geometry.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using Corners = std::vector<TPoint2D>;

/// Cells are the unit of length. Less than the contact of runs, more than rounding errors.
constexpr double kSlack = 1e-6;
/// Blocks of occupied cells are squares of up to so many cells.
constexpr int kMaxBlock = 2;

/// The largest a.p over corners.
double support(const Corners& corners, const TPoint2D& a) {
  double most = -HUGE_VAL;
  for (const TPoint2D& p : corners) most = std::max(most, a.x * p.x + a.y * p.y);
  return most;
}

/// Convex polygons in a footprint that cover it, in cells, counter-clockwise; none if it cannot be
/// divided.
std::vector<Corners> convex_parts(const Footprint& footprint, double resolution) {
  mrpt::math::TPolygon2D outline;
  for (const TPoint2D& p : footprint.corners()) outline.push_back(p * (1 / resolution));
  std::vector<mrpt::math::TPolygon2D> split;
  if (!mrpt::math::splitInConvexComponents(outline, split)) split = {outline};
  std::vector<Corners> parts;
  double area = 0;
  for (const auto& part : split) {
    if (!part.isConvex()) return {};
    Corners& corners = parts.emplace_back(part.begin(), part.end());
    const double part_area = signed_area({corners});
    if (part_area < 0) std::reverse(corners.begin(), corners.end());
    area += std::abs(part_area);
  }
  const double whole = signed_area({{outline.begin(), outline.end()}});
  return std::abs(area - whole) <= kSlack * whole ? parts : std::vector<Corners>();
}

/// The points that a convex part covers at all headings near one, and the directions in
/// which its sides face.
struct CommonPart {
  Corners corners, normals;
};

CommonPart common_part(const Corners& part, double heading, double half) {
  const double c = math::cos(heading), s = math::sin(heading);
  const double dc = math::cos(half), ds = math::sin(half);
  CommonPart common;
  for (const TPoint2D& p : part) common.corners.emplace_back(c * p.x - s * p.y, s * p.x + c * p.y);
  const Corners turned = common.corners;
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const TPoint2D side = turned[(i + 1) % turned.size()] - turned[i];
    const double length = math::hypot(side.x, side.y);
    if (length == 0) continue;
    const TPoint2D n(side.y / length, -side.x / length);
    const double reach = n.x * turned[i].x + n.y * turned[i].y - kSlack;
    // The largest n.q of a point q is at an end of the headings, or |q| where q is in the direction
    // n at one of them, which the third bounds.
    const TPoint2D first(dc * n.x - ds * n.y, ds * n.x + dc * n.y),
        last(dc * n.x + ds * n.y, -ds * n.x + dc * n.y);
    for (const auto& [normal, bound] :
         {std::pair(first, reach), std::pair(last, reach), std::pair(n, dc * reach)}) {
      common.corners = clipped(common.corners, {{-normal.x, -normal.y}, -bound});
      common.normals.push_back(normal);
    }
  }
  return common;
}

template <std::size_t kWords>
std::array<std::uint64_t, kWords> all_headings() {
  std::array<std::uint64_t, kWords> all;
  all.fill(~std::uint64_t{0});
  return all;
}

/// The neighbors of headings.
template <std::size_t kWords>
std::array<std::uint64_t, kWords> turned(const std::array<std::uint64_t, kWords>& headings) {
  std::array<std::uint64_t, kWords> all;
  for (std::size_t w = 0; w < kWords; ++w)
    all[w] = (headings[w] << 1U) | (headings[(w + kWords - 1) % kWords] >> 63U) |
             (headings[w] >> 1U) | (headings[(w + 1) % kWords] << 63U);
  return all;
}

/// All that turning leads to from `headings`, and from those reached before.
template <std::size_t kWords>
std::array<std::uint64_t, kWords> spread(const std::array<std::uint64_t, kWords>& headings,
                                         const std::array<std::uint64_t, kWords>& open,
                                         std::array<std::uint64_t, kWords> all) {
  for (std::size_t w = 0; w < kWords; ++w) all[w] |= headings[w] & open[w];
  if (open == all_headings<kWords>() && all != std::array<std::uint64_t, kWords>{}) return open;
  for (std::array<std::uint64_t, kWords> before = {}; before != all;) {
    before = all;
    const std::array<std::uint64_t, kWords> neighbors = turned(before);
    for (std::size_t w = 0; w < kWords; ++w) all[w] |= neighbors[w] & open[w];
  }
  return all;
}

}  // namespace

template <std::size_t kDivisions>
PoseBoxes<kDivisions>::PoseBoxes(const World& world, double enclosing_radius, const TPoint2D& goal,
                                 double reach)
    : cells_(world.occupancy()),
      width_(cells_.size_x() * kSide),
      height_(cells_.size_y() * kSide),
      reach_(static_cast<int>(std::ceil(enclosing_radius / cells_.resolution())) + 1),
      open_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)),
      goal_(goal),
      goal_reach_(reach),
      leading_(open_.size(), Headings{}),
      is_divided_(cells_.cells().size(), 1) {}

template <std::size_t kDivisions>
PoseBoxes<kDivisions>::PoseBoxes(const World& world, const Footprint& footprint,
                                 const TPoint2D& goal, double reach)
    : PoseBoxes(world, footprint.enclosing_radius(), goal, reach) {
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      if (!cells_.occupied(x / kSide, y / kSide)) open_[index(x, y)] = all_headings<kDivisions>();
  divide(world, footprint);
}

template <std::size_t kDivisions>
template <std::size_t kFewer>
PoseBoxes<kDivisions>::PoseBoxes(const World& world, const Footprint& footprint,
                                 const TPoint2D& goal, double reach,
                                 const PoseBoxes<kFewer>& larger)
    : PoseBoxes(world, footprint.enclosing_radius(), goal, reach) {
  constexpr int kInLarger = static_cast<int>(kDivisions / kFewer);
  std::fill(is_divided_.begin(), is_divided_.end(), 0);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const auto& known = larger.leading_[larger.index(x / kInLarger, y / kInLarger)];
      Headings& open = open_[index(x, y)];
      if (known == typename PoseBoxes<kFewer>::Headings{}) continue;
      if (known == all_headings<kFewer>()) {
        open = all_headings<kDivisions>();
        continue;
      }
      is_divided_[cells_.index(x / kSide, y / kSide)] = 1;
      for (unsigned heading = 0; heading < kHeadings; ++heading) {
        const unsigned of = heading / kInLarger;
        open[heading / 64] |= (known[of / 64] >> (of % 64) & 1U) << (heading % 64);
      }
    }
  divide(world, footprint);
}

/// Closes what blocks close, and finds what leads to the goal.
template <std::size_t kDivisions>
void PoseBoxes<kDivisions>::divide(const World& world, const Footprint& footprint) {
  const std::vector<Corners> parts = convex_parts(footprint, cells_.resolution());
  const std::vector<std::uint8_t> near = near_free_cells(world);
  for (int block = 1; block <= kMaxBlock; ++block) close(block, parts, near);
  flood();
}

template <std::size_t kDivisions>
std::optional<std::size_t> PoseBoxes<kDivisions>::position_of(const TPoint2D& point) const {
  const TPoint2D at = cells_.to_cells(point) * kSide;
  const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return std::nullopt;
  return index(x, y);
}

template <std::size_t kDivisions>
bool PoseBoxes<kDivisions>::leads_to_goal(const TPose2D& pose) const {
  const std::optional<std::size_t> position = position_of(TPoint2D(pose));
  const double turn = pose.phi / (2 * M_PI);
  const auto heading = static_cast<unsigned>((turn - std::floor(turn)) * kHeadings) % kHeadings;
  return position && (leading_[*position][heading / 64] >> (heading % 64) & 1U) != 0;
}

template <std::size_t kDivisions>
bool PoseBoxes<kDivisions>::is_wide(const TPoint2D& point) const {
  const std::optional<std::size_t> position = position_of(point);
  return position && open_[*position] == all_headings<kDivisions>();
}

template <std::size_t kDivisions>
bool PoseBoxes<kDivisions>::separates(const TPose2D& start) const {
  const double slack = kSlack * cells_.resolution();
  for (const double dx : {-slack, slack})
    for (const double dy : {-slack, slack})
      for (const double turn : {-kSlack, kSlack})
        if (leads_to_goal({start.x + dx, start.y + dy, start.phi + turn})) return false;
  return true;
}

template <std::size_t kDivisions>
std::size_t PoseBoxes<kDivisions>::index(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
         static_cast<std::size_t>(x);
}

/// Visits the positions of the goal.
template <std::size_t kDivisions>
template <typename Visit>
void PoseBoxes<kDivisions>::for_each_goal(const Visit& visit) const {
  const TPoint2D at = cells_.to_cells(goal_) * kSide;
  const double radius = goal_reach_ / cells_.resolution() * kSide + kSlack;
  const auto first = [&](double from) {
    return std::max(0, static_cast<int>(std::floor(from - radius)));
  };
  for (int y = first(at.y); y <= at.y + radius && y < height_; ++y)
    for (int x = first(at.x); x <= at.x + radius && x < width_; ++x) {
      const double dx = std::max({x - at.x, at.x - x - 1, 0.0}),
                   dy = std::max({y - at.y, at.y - y - 1, 0.0});
      if (dx * dx + dy * dy <= radius * radius) visit(x, y);
    }
}

/// An index of cells, also of those of the ring outside.
template <std::size_t kDivisions>
std::size_t PoseBoxes<kDivisions>::near_index(int x, int y) const {
  return static_cast<std::size_t>(y + kRing) *
             static_cast<std::size_t>(cells_.size_x() + 2 * kRing) +
         static_cast<std::size_t>(x + kRing);
}

template <std::size_t kDivisions>
std::size_t PoseBoxes<kDivisions>::offset_index(int dx, int dy) const {
  return static_cast<std::size_t>(dy + reach_) * static_cast<std::size_t>(2 * reach_ + 1) +
         static_cast<std::size_t>(dx + reach_);
}

/// Occupied cells, by near_index(), that are so near a free one that they may close boxes which
/// those nearer do not.
template <std::size_t kDivisions>
std::vector<std::uint8_t> PoseBoxes<kDivisions>::near_free_cells(const World& world) const {
  const double far = M_SQRT2 * (kRing + 1) * cells_.resolution();
  std::vector<std::uint8_t> near(
      near_index(cells_.size_x() + kRing - 1, cells_.size_y() + kRing - 1) + 1);
  for (int y = 0; y < cells_.size_y(); ++y)
    for (int x = 0; x < cells_.size_x(); ++x) {
      if (cells_.occupied(x, y) || world.distance_field().at_center(x, y) > far) continue;
      for (int dy = -kRing; dy <= kRing; ++dy)
        for (int dx = -kRing; dx <= kRing; ++dx)
          if (cells_.occupied(x + dx, y + dy)) near[near_index(x + dx, y + dy)] = 1;
    }
  return near;
}

/// The headings at which the robot meets a block of cells at each offset from a cell at all
/// positions of one of the cell's boxes.
template <std::size_t kDivisions>
std::vector<typename PoseBoxes<kDivisions>::Headings> PoseBoxes<kDivisions>::closed_by(
    int block, int box_x, int box_y, const std::vector<Corners>& parts) const {
  std::vector<Headings> closed(offset_index(reach_, reach_) + 1, Headings{});
  const double half = M_PI / kHeadings, side = 1.0 / kSide, size = block;
  const double x = side * box_x, y = side * box_y;
  const Corners box = {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
  const Corners square = {{0, 0}, {size, 0}, {size, size}, {0, size}};
  for (unsigned heading = 0; heading < kHeadings; ++heading)
    for (const Corners& part : parts) {
      CommonPart common = common_part(part, (2 * heading + 1) * half, half);
      if (common.corners.size() < 3) continue;
      // The robot meets the block at the positions of the Minkowski sum of the block and the
      // mirrored part, whose sides face as those of the two do.
      for (TPoint2D& p : common.corners) p = TPoint2D(-p.x, -p.y);
      for (const TPoint2D& n : Corners{{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        common.normals.push_back(n);
      std::vector<HalfPlane> offsets;
      for (const TPoint2D& normal : common.normals) {
        const TPoint2D n(-normal.x, -normal.y);
        offsets.push_back({n, support(box, n) - support(square, n) - support(common.corners, n)});
      }
      for (int dy = -reach_; dy <= reach_; ++dy)
        for (int dx = -reach_; dx <= reach_; ++dx)
          if (std::all_of(offsets.begin(), offsets.end(), [&](const HalfPlane& allowed) {
                return allowed.excess(TPoint2D(dx, dy)) >= 0;
              }))
            closed[offset_index(dx, dy)][heading / 64] |= std::uint64_t{1} << (heading % 64);
    }
  return closed;
}

/// Closes what full blocks of cells close.
template <std::size_t kDivisions>
void PoseBoxes<kDivisions>::close(int block, const std::vector<Corners>& parts,
                                  const std::vector<std::uint8_t>& near) {
  std::vector<std::pair<int, int>> blocks;
  for (int y = -kRing; y <= cells_.size_y() + kRing - block; ++y)
    for (int x = -kRing; x <= cells_.size_x() + kRing - block; ++x) {
      bool is_full = true;
      for (int dy = 0; dy < block; ++dy)
        for (int dx = 0; dx < block; ++dx)
          is_full = is_full && near[near_index(x + dx, y + dy)] != 0;
      if (is_full) blocks.emplace_back(x, y);
    }
  for (int box_y = 0; box_y < kSide; ++box_y)
    for (int box_x = 0; box_x < kSide; ++box_x) {
      const std::vector<Headings> closed = closed_by(block, box_x, box_y, parts);
      for (const auto& [x, y] : blocks)
        for (int dy = std::max(-reach_, y - cells_.size_y() + 1); dy <= std::min(reach_, y); ++dy)
          for (int dx = std::max(-reach_, x - cells_.size_x() + 1); dx <= std::min(reach_, x);
               ++dx) {
            if (is_divided_[cells_.index(x - dx, y - dy)] == 0) continue;
            Headings& open = open_[index((x - dx) * kSide + box_x, (y - dy) * kSide + box_y)];
            const Headings& here = closed[offset_index(dx, dy)];
            for (std::size_t w = 0; w < kDivisions; ++w) open[w] &= ~here[w];
          }
    }
}

template <std::size_t kDivisions>
void PoseBoxes<kDivisions>::flood() {
  std::vector<std::pair<int, int>> stack;
  const auto enter = [&](int x, int y, const Headings& headings) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    Headings& known = leading_[index(x, y)];
    const Headings all = spread(headings, open_[index(x, y)], known);
    if (all == known) return;
    known = all;
    stack.emplace_back(x, y);
  };
  for_each_goal([&](int x, int y) { enter(x, y, all_headings<kDivisions>()); });
  while (!stack.empty()) {
    const auto [x, y] = stack.back();
    stack.pop_back();
    const Headings here = leading_[index(x, y)];
    enter(x + 1, y, here);
    enter(x - 1, y, here);
    enter(x, y + 1, here);
    enter(x, y - 1, here);
  }
}

template <std::size_t kDivisions>
std::vector<std::uint16_t> PoseBoxes<kDivisions>::steps_to_goal() const {
  constexpr std::uint16_t kFar = 0xffff;
  std::vector<std::uint16_t> steps(leading_.size(), kFar);
  std::vector<Headings> known(leading_.size(), Headings{}), fresh = known;
  std::vector<std::size_t> next;
  const auto reach_for = [&](std::size_t i, const Headings& headings) {
    Headings all = fresh[i];
    for (std::size_t w = 0; w < kDivisions; ++w)
      all[w] |= headings[w] & leading_[i][w] & ~known[i][w];
    if (all == fresh[i]) return;
    if (fresh[i] == Headings{}) next.push_back(i);
    fresh[i] = all;
  };
  for_each_goal([&](int x, int y) { reach_for(index(x, y), all_headings<kDivisions>()); });
  const auto width = static_cast<std::size_t>(width_);
  for (std::uint16_t step = 0; !next.empty() && step < kFar; ++step) {
    std::vector<std::pair<std::size_t, Headings>> now;
    for (const std::size_t i : std::exchange(next, {})) {
      now.emplace_back(i, std::exchange(fresh[i], Headings{}));
      for (std::size_t w = 0; w < kDivisions; ++w) known[i][w] |= now.back().second[w];
      steps[i] = std::min(steps[i], step);
    }
    for (const auto& [i, here] : now) {
      reach_for(i, turned(here));
      const auto x = static_cast<int>(i % width), y = static_cast<int>(i / width);
      // Steps to the side, then also diagonal ones, and so on: nearly as long as a straight way.
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if ((dx == 0 || dy == 0 || step % 2 == 1) && x + dx >= 0 && y + dy >= 0 &&
              x + dx < width_ && y + dy < height_)
            reach_for(index(x + dx, y + dy), here);
    }
  }
  return steps;
}

template class PoseBoxes<1>;
template class PoseBoxes<2>;
template class PoseBoxes<4>;
template PoseBoxes<2>::PoseBoxes(const World&, const Footprint&, const TPoint2D&, double,
                                 const PoseBoxes<1>&);
template PoseBoxes<4>::PoseBoxes(const World&, const Footprint&, const TPoint2D&, double,
                                 const PoseBoxes<2>&);

bool can_divide(const World& world, int divisions) {
  constexpr std::size_t kMaxBoxes = 16'000'000;  // of 64 directions
  return world.occupancy().cells().size() *
             static_cast<std::size_t>(divisions * divisions * divisions) <=
         kMaxBoxes;
}

bool is_obstructed(const World& world, const Footprint& footprint, const TPose2D& start,
                   const TPoint2D& goal, double reach, int divisions) {
  if (footprint.is_disc() || !can_divide(world, 1)) return false;
  const PoseBoxes<1> large(world, footprint, goal, reach);
  if (large.separates(start)) return true;
  if (divisions < 2 || !can_divide(world, 2)) return false;
  const PoseBoxes<2> small(world, footprint, goal, reach, large);
  if (small.separates(start)) return true;
  return divisions > 2 && can_divide(world, 4) &&
         PoseBoxes<4>(world, footprint, goal, reach, small).separates(start);
}

void refuse_obstructed(const PlanningProblem& problem, const Footprint& footprint, double reach,
                       References& references) {
  if (!references.shortest || references.shortest->planner_length) return;
  const TPose2D start(problem.start.x, problem.start.y, problem.start_heading);
  if (!is_obstructed(problem.world, footprint, start, problem.goal, reach, 4)) return;
  references.shortest.reset();
  references.safest.reset();
  references.shortest_reason = references.safest_reason = kObstructed;
}

}  // namespace slalom
