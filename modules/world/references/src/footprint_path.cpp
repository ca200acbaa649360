// SPDX-License-Identifier: BSD-3-Clause
#include "pose_boxes.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/core/pose.h>
#include <slalom/references/disc_path.h>
#include <slalom/references/footprint_contact.h>
#include <slalom/references/footprint_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// Spacings of positions as fractions of the robot's half width, one after the other.
constexpr std::array kSpacings = {0.125, 0.2};
/// How near to the goal a path ends, in the same.
constexpr double kReach = 1.0 / 6;
/// Weights of the distance that is left, among cells and by boxes: more is faster, and paths get
/// longer.
constexpr double kGreed = 1.3, kGreedByBoxes = 1.7;
constexpr char kUndecided[] =
    "no path was found for the robot's shape, nor proved that there is none";
/// Length (m) that is worth a turn by 1 rad, as a fraction of the enclosing radius.
constexpr double kTurnCost = 0.2;
constexpr int kMaxExpanded = 30000;
constexpr int kDirections = 32;

/// Steps of one octant; the direction of each leads from position to position.
constexpr std::array<std::array<int, 2>, 4> kSteps = {{{1, 0}, {3, 1}, {2, 1}, {3, 2}}};

/// The step of a direction, in their order of angles.
std::array<int, 2> step_of(int direction) {
  const int octant = direction / 4 % 8, i = direction % 4;
  const bool is_mirrored = octant % 2 == 1;
  // The octants with odd numbers have the mirror images in reverse order, from (1, 1) on.
  std::array<int, 2> step =
      is_mirrored ? (i == 0 ? std::array{1, 1} : kSteps[4U - static_cast<unsigned>(i)])
                  : kSteps[static_cast<unsigned>(i)];
  if (is_mirrored) std::swap(step[0], step[1]);
  for (int quarter = octant / 2; quarter > 0; --quarter) step = {-step[1], step[0]};
  return step;
}

constexpr int kStart = -1;

/// A position and a direction by their numbers; kStart is the direction at the start.
struct Node {
  std::int32_t x = 0, y = 0;
  int direction = 0;
  bool operator==(const Node& o) const { return x == o.x && y == o.y && direction == o.direction; }
};

struct NodeHash {
  std::size_t operator()(const Node& n) const {
    return (static_cast<std::size_t>(static_cast<std::uint32_t>(n.x)) << 38U) ^
           (static_cast<std::size_t>(static_cast<std::uint32_t>(n.y)) << 8U) ^
           static_cast<std::size_t>(n.direction);
  }
};

/// Distances (m) to the goal along cells with a given clearance.
class CellDistances {
 public:
  CellDistances(const World& world, const TPoint2D& goal, double clearance)
      : cells_(world.occupancy()),
        distance_(cells_.cells().size(), std::numeric_limits<double>::infinity()) {
    const TPoint2D at = cells_.to_cells(goal);
    push(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)), 0.0);
    while (!queue_.empty()) {
      const auto [distance, index] = queue_.top();
      queue_.pop();
      if (distance > distance_[index]) continue;
      const int width = cells_.size_x(), x = static_cast<int>(index) % width,
                y = static_cast<int>(index) / width;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (cells_.inside(x + dx, y + dy) &&
              world.distance_field().at_center(x + dx, y + dy) >= clearance)
            push(x + dx, y + dy,
                 distance + (dx != 0 && dy != 0 ? M_SQRT2 : 1) * cells_.resolution());
    }
  }

  double at(const TPoint2D& p) const {
    const TPoint2D cell = cells_.to_cells(p);
    const int x = static_cast<int>(std::floor(cell.x)), y = static_cast<int>(std::floor(cell.y));
    return cells_.inside(x, y) ? distance_[cells_.index(x, y)]
                               : std::numeric_limits<double>::infinity();
  }

 private:
  void push(int x, int y, double distance) {
    if (!cells_.inside(x, y) || distance >= distance_[cells_.index(x, y)]) return;
    distance_[cells_.index(x, y)] = distance;
    queue_.push({distance, cells_.index(x, y)});
  }

  using Entry = std::pair<double, std::size_t>;
  const Occupancy& cells_;
  std::vector<double> distance_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// m, from the center to the nearer side. What a robot that drives ahead comes closest to is beside
/// its center then, be it after a turn in place: it is no closer than this, but at start and goal.
double side_clearance(const Footprint& footprint) {
  double nearest = footprint.is_disc() ? footprint.enclosing_radius() : HUGE_VAL;
  const std::vector<TPoint2D>& corners = footprint.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TPoint2D &p = corners[i], &q = corners[(i + 1) % corners.size()];
    if ((p.x < 0) != (q.x < 0))
      nearest = std::min(nearest, std::abs(p.y + (q.y - p.y) * p.x / (p.x - q.x)));
  }
  return nearest;
}

/// The weighted distance (m) to the goal that is left from a pose; infinite: no way is left.
using Guide = std::function<double(const TPose2D&)>;

/// The motion that a search is for.
struct SearchProblem {
  const World& world;
  const Footprint& footprint;
  TPose2D start;
  TPoint2D goal;
  double margin;  ///< m
};

/// Weighted A* among poses.
class PoseSearch {
 public:
  PoseSearch(const SearchProblem& problem, const Guide& guide)
      : guide_(guide),
        contact_(make_footprint_contact(problem.world, problem.footprint)),
        start_(problem.start),
        goal_(problem.goal),
        margin_(problem.margin),
        reach_(kReach * problem.footprint.half_width()),
        turn_cost_(kTurnCost * problem.footprint.enclosing_radius()) {}
  virtual ~PoseSearch() = default;

  std::optional<FootprintPath> run() {
    const Node first{0, 0, kStart};
    offer(first, first, 0);
    for (int expanded = 0; !queue_.empty() && expanded < kMaxExpanded; ++expanded) {
      const Node node = queue_.top().node;
      queue_.pop();
      State& state = states_.at(node);
      if (state.closed) continue;
      state.closed = true;
      if (distance_between(TPoint2D(pose(node)), goal_) <= reach_) return path_to(node);
      expand(node, state.cost);
    }
    return std::nullopt;
  }

 protected:
  virtual TPose2D pose_of(const Node& node) const = 0;  ///< of one that is not the start
  virtual void expand(const Node& node, double cost) = 0;

  TPose2D pose(const Node& node) const { return node.direction == kStart ? start_ : pose_of(node); }

  bool is_known(const Node& node) const {
    const auto found = states_.find(node);
    return found != states_.end() && found->second.closed;
  }

  /// Moves straight while it turns to the nearer side.
  void move(const Node& node, double cost, const Node& next) {
    if (is_known(next)) return;
    const TPose2D from = pose(node), to = pose(next);
    const double turn = mrpt::math::wrapToPi(to.phi - from.phi);
    if (contact_->is_free(from, {to.x, to.y, from.phi + turn}, margin_))
      offer(next, node, cost + distance_between(from, TPoint2D(to)) + turn_cost_ * std::abs(turn));
  }

  const TPose2D& start() const { return start_; }

 private:
  struct State {
    Node from;
    double cost = std::numeric_limits<double>::infinity();
    bool closed = false;
  };
  struct Entry {
    double bound;
    Node node;
    /// The last in the queue first; equal bounds in an order of their own.
    bool operator<(const Entry& o) const {
      return std::tie(bound, node.x, node.y, node.direction) >
             std::tie(o.bound, o.node.x, o.node.y, o.node.direction);
    }
  };

  void offer(const Node& node, const Node& from, double cost) {
    State& state = states_[node];
    if (state.closed || cost >= state.cost) return;
    state = {from, cost, false};
    const double rest = guide_(pose(node));
    if (rest < std::numeric_limits<double>::infinity()) queue_.push({cost + rest, node});
  }

  FootprintPath path_to(Node node) const {
    FootprintPath path;
    path.poses.push_back(pose(node));
    while (node.direction != kStart) {
      node = states_.at(node).from;
      path.poses.push_back(pose(node));
    }
    std::reverse(path.poses.begin(), path.poses.end());
    for (std::size_t i = 1; i < path.poses.size(); ++i)
      path.length += distance_between(path.poses[i - 1], path.poses[i]);
    return path;
  }

  const Guide& guide_;
  std::unique_ptr<FootprintContact> contact_;
  TPose2D start_;
  TPoint2D goal_;
  double margin_;     ///< m
  double reach_;      ///< m
  double turn_cost_;  ///< m/rad
  std::unordered_map<Node, State, NodeHash> states_;
  std::priority_queue<Entry> queue_;
};

/// Turns in place and drives among positions `spacing` (m) apart around the start.
class LatticeSearch : public PoseSearch {
 public:
  LatticeSearch(const SearchProblem& problem, const Guide& guide, double spacing,
                PolygonMotion motion)
      : PoseSearch(problem, guide), spacing_(spacing), motion_(motion) {
    for (int i = 0; i < kDirections; ++i) {
      const auto [x, y] = step_of(i);
      headings_[static_cast<unsigned>(i)] = math::atan2(y, x);
    }
  }

 private:
  TPose2D pose_of(const Node& node) const override {
    const TPoint2D p = TPoint2D(start()) + TPoint2D(node.x, node.y) * spacing_;
    return {p.x, p.y, headings_[static_cast<unsigned>(node.direction)]};
  }

  void turn(const Node& node, double cost, int direction) {
    move(node, cost, {node.x, node.y, (direction + kDirections) % kDirections});
  }

  void expand(const Node& node, double cost) override {
    if (node.direction == kStart) {
      // The neighbors of the heading; the other way around is a turn as well.
      int next = 0;
      for (int i = 0; i < kDirections; ++i)
        if (ahead(i) < ahead(next)) next = i;
      turn(node, cost, next);
      turn(node, cost, next - 1);
      return;
    }
    turn(node, cost, node.direction + 1);
    turn(node, cost, node.direction - 1);
    const auto [x, y] = step_of(node.direction);
    const int longest = std::max(1, static_cast<int>(kLongStep / math::hypot(x, y)));
    for (const int steps : {1, longest}) {
      move(node, cost, {node.x + steps * x, node.y + steps * y, node.direction});
      if (motion_ != PolygonMotion::Forward)
        move(node, cost, {node.x - steps * x, node.y - steps * y, node.direction});
      if (steps == longest) break;
    }
  }

  /// rad, the angle to the left from the start's heading to a direction.
  double ahead(int direction) const {
    const double angle = headings_[static_cast<unsigned>(direction)] - start().phi;
    return angle - 2 * M_PI * std::floor(angle / (2 * M_PI));
  }

  static constexpr double kLongStep = 8;  // in positions
  double spacing_;                        ///< m
  PolygonMotion motion_;
  std::array<double, kDirections> headings_ = {};
};

/// Moves in any direction among the corners of small boxes of poses, and of larger ones where the
/// robot may turn as it likes: the middle between cells is one, where the robot may just fit.
class BoxSearch : public PoseSearch {
 public:
  BoxSearch(const SearchProblem& problem, const Guide& guide, const PoseBoxes<1>& boxes)
      : PoseSearch(problem, guide),
        boxes_(boxes),
        origin_(problem.world.occupancy().to_world(0, 0)),
        side_(problem.world.occupancy().resolution() / kInCell) {}

 private:
  static constexpr int kInCell = 4, kHeadings = 256, kWideTurn = 8;

  TPose2D pose_of(const Node& node) const override {
    return {origin_.x + node.x * side_, origin_.y + node.y * side_,
            mrpt::math::wrapToPi(node.direction * 2 * M_PI / kHeadings)};
  }

  Node near(const TPose2D& pose) const {
    const double turn = pose.phi / (2 * M_PI);
    return {static_cast<std::int32_t>(std::lround((pose.x - origin_.x) / side_)),
            static_cast<std::int32_t>(std::lround((pose.y - origin_.y) / side_)),
            static_cast<int>(std::lround((turn - std::floor(turn)) * kHeadings)) % kHeadings};
  }

  void expand(const Node& node, double cost) override {
    if (node.direction == kStart) return move(node, cost, near(start()));
    const bool is_wide = boxes_.is_wide(TPoint2D(pose(node)));
    const int step = is_wide ? kInCell : 1, turn = is_wide ? kWideTurn : 1;
    const auto snapped = [](int i, int by) { return (i - (i < 0 ? by - 1 : 0)) / by * by; };
    const Node from = {snapped(node.x, step), snapped(node.y, step), snapped(node.direction, turn)};
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        move(node, cost, {from.x + dx * step, from.y + dy * step, node.direction});
    for (const int by : {-turn, turn})
      move(node, cost, {node.x, node.y, (from.direction + by + kHeadings) % kHeadings});
  }

  const PoseBoxes<1>& boxes_;
  TPoint2D origin_;
  double side_;  ///< m
};

/// Turns to a point and drives there, or turns its back; false if the robot comes closer than the
/// margin.
bool drive_to(const TPoint2D& next, const FootprintContact& contact, double margin,
              FootprintPath& path, bool backward = false) {
  const TPose2D at = path.poses.back();
  const double length = distance_between(at, next);
  if (length == 0) return true;
  const double ahead = math::atan2(next.y - at.y, next.x - at.x);
  const double heading = backward ? mrpt::math::wrapToPi(ahead + M_PI) : ahead;
  const TPose2D turned(at.x, at.y, heading), driven(next.x, next.y, heading);
  if (!contact.is_free(at, turned, margin) || !contact.is_free(turned, driven, margin))
    return false;
  path.poses.insert(path.poses.end(), {turned, driven});
  path.length += length;
  return true;
}

/// The path of a disc, along which the robot drives: it turns in place where the path bends.
/// nullopt if the robot touches something.
std::optional<FootprintPath> along(const DiscPath& disc, const Occupancy& cells,
                                   const FootprintContact& contact, const TPose2D& start,
                                   double margin) {
  constexpr double kExcess = 1e-3;  // of the length: fewer turns on arcs
  FootprintPath path;
  path.poses.push_back(start);
  for (const TPoint2D& next : to_polyline(disc, cells, kExcess))
    if (!drive_to(next, contact, margin, path)) return std::nullopt;
  return path;
}

/// Along the shortest path of a disc; wider ones leave more room to turn.
std::optional<FootprintPath> along_a_disc(const World& world, const Footprint& footprint,
                                          const FootprintContact& contact, const TPose2D& start,
                                          const TPoint2D& goal, double margin) {
  const double least = footprint.half_width() + margin, most = footprint.enclosing_radius();
  constexpr double kExcess = 5e-4;  // m: contact is somewhat nearer than the margin
  const auto between = [&](double room) { return least + room * (most - least); };
  for (const double radius :
       {between(0.02), between(0.25), between(0.5), between(0.75), most + margin + kExcess}) {
    std::string no_path;
    const auto disc = shortest_disc_path(world.occupancy(), radius, TPoint2D(start), goal, no_path);
    if (!disc) break;  // nor has a wider one
    if (auto path = along(*disc, world.occupancy(), contact, start, margin)) return path;
  }
  return std::nullopt;
}

/// From near the goal to it, if the motion of the path leads there.
void complete(const TPoint2D& goal, const FootprintContact& contact, double margin,
              FootprintPath& path) {
  if (drive_to(goal, contact, margin, path) || path.motion == PolygonMotion::Forward) return;
  if (drive_to(goal, contact, margin, path, true) || path.motion == PolygonMotion::Reversing)
    return;
  const TPose2D last = path.poses.back(), moved(goal.x, goal.y, last.phi);
  if (!contact.is_free(last, moved, margin)) return;
  path.poses.push_back(moved);
  path.length += distance_between(last, moved);
}

/// Guides by the number of boxes between a pose and the goal.
template <std::size_t kDivisions>
Guide guide_by(const PoseBoxes<kDivisions>& boxes, const World& world) {
  const double side = world.occupancy().resolution() / static_cast<double>(kDivisions);
  return [&boxes, steps = boxes.steps_to_goal(), side](const TPose2D& pose) {
    return boxes.leads_to_goal(pose)
               ? kGreedByBoxes * side * steps[*boxes.position_of(TPoint2D(pose))]
               : std::numeric_limits<double>::infinity();
  };
}

}  // namespace

std::optional<FootprintPath> find_footprint_path(const World& world, const Footprint& footprint,
                                                 const TPose2D& start, const TPoint2D& goal,
                                                 double margin, std::string& reason,
                                                 SearchEffort effort, PolygonMotion motion) {
  if (!shortest_disc_path(world.occupancy(), footprint.inscribed_radius(), TPoint2D(start), goal,
                          reason))
    return std::nullopt;
  const auto contact = make_footprint_contact(world, footprint);
  if (contact->touches(start)) {
    reason = "the robot touches an obstacle at the start";
    return std::nullopt;
  }
  if (auto path = along_a_disc(world, footprint, *contact, start, goal, margin)) return path;
  const double reach = kReach * footprint.half_width();
  std::optional<PoseBoxes<1>> boxes;
  if (can_divide(world, 1)) boxes.emplace(world, footprint, goal, reach);
  if (boxes && boxes->separates(start)) {
    reason = kObstructed;
    return std::nullopt;
  }
  const SearchProblem problem{world, footprint, start, goal, margin};
  const auto finish = [&](std::optional<FootprintPath> path, PolygonMotion by) {
    if (!path) return path;
    path->motion = by;
    complete(goal, *contact, margin, *path);
    return path;
  };
  const auto on_lattice = [&](double spacing, PolygonMotion by, const Guide& guide) {
    return finish(LatticeSearch(problem, guide, spacing * footprint.half_width(), by).run(), by);
  };
  reason = kUndecided;
  if (effort == SearchEffort::Quick || !boxes) {
    // Half a cell less, since the robot may be anywhere in it.
    const double clearance =
        side_clearance(footprint) + margin - world.occupancy().resolution() * M_SQRT1_2;
    const CellDistances rest(world, goal, clearance);
    return on_lattice(kSpacings[0], PolygonMotion::Forward,
                      [&](const TPose2D& pose) { return kGreed * rest.at(TPoint2D(pose)); });
  }
  const Guide guide = guide_by(*boxes, world);
  for (const double spacing : kSpacings)
    if (auto path = on_lattice(spacing, PolygonMotion::Forward, guide)) return path;
  std::optional<PoseBoxes<2>> finer;
  if (can_divide(world, 2)) finer.emplace(world, footprint, goal, reach, *boxes);
  if (finer && finer->separates(start)) {
    reason = kObstructed;
    return std::nullopt;
  }
  if (motion >= PolygonMotion::Reversing)
    if (auto path = on_lattice(kSpacings[0], PolygonMotion::Reversing, guide)) return path;
  if (motion == PolygonMotion::Holonomic) {
    const Guide fine = finer ? guide_by(*finer, world) : guide;
    if (auto path = finish(BoxSearch(problem, fine, *boxes).run(), PolygonMotion::Holonomic))
      return path;
  }
  if (finer && can_divide(world, 4) &&
      PoseBoxes<4>(world, footprint, goal, reach, *finer).separates(start))
    reason = kObstructed;
  return std::nullopt;
}

}  // namespace slalom
