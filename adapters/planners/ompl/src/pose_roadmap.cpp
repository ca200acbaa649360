// SPDX-License-Identifier: BSD-3-Clause
#include "pose_roadmap.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/references/disc_path.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr int kGoalHeadings = 16;

struct Node {
  TPose2D pose;
  double progress = 0;  ///< part of the path on which it lies; edges lead to a larger one
  double cost = std::numeric_limits<double>::infinity();  ///< m, from the start
  int parent = -1;
};

double direction(const TPoint2D& from, const TPoint2D& to) {
  return math::atan2(to.y - from.y, to.x - from.x);
}

class Roadmap {
 public:
  Roadmap(const PlanningProblem& problem, const PoseMotions& motions)
      : problem_(problem), motions_(motions) {
    nodes_.push_back({{problem.start.x, problem.start.y, problem.start_heading}, 0, 0, -1});
    if (turning_radius() > 0) add_around_start();
    for (const double radius : radii()) add_along_path(radius);
    for (const TPose2D& pose : goal_poses(problem, motions)) add(pose, kGoal);
    std::stable_sort(nodes_.begin(), nodes_.end(),
                     [](const Node& a, const Node& b) { return a.progress < b.progress; });
  }

  std::vector<TPose2D> shortest_path() {
    for (std::size_t i = 1; i < nodes_.size(); ++i) connect(i);
    int best = -1;
    for (std::size_t i = 1; i < nodes_.size(); ++i)
      if (nodes_[i].progress == kGoal && nodes_[i].parent >= 0 &&
          (best < 0 || nodes_[i].cost < node(best).cost))
        best = static_cast<int>(i);
    std::vector<TPose2D> poses;
    for (int i = best; i >= 0; i = node(i).parent) poses.push_back(node(i).pose);
    std::reverse(poses.begin(), poses.end());
    return poses;
  }

 private:
  static constexpr double kAroundStart = 1e-6, kGoal = 2;  ///< progress

  double turning_radius() const { return motions_.robot().min_turning_radius; }
  const Node& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }

  /// A polygon is in contact below a clearance of 0.1 mm, and slow to check slightly above it.
  std::vector<double> radii() const {
    const Footprint shape = motions_.robot().shape();
    const double smallest = problem_.robot_radius + (shape.is_disc() ? 0 : 5e-4);
    const double largest = std::max(shape.enclosing_radius(), turning_radius());
    std::vector<double> radii = {smallest};
    for (const double part : {0.0625, 0.125, 0.25, 0.5, 1.0})
      if (largest > smallest) radii.push_back(smallest + part * (largest - smallest));
    return radii;
  }

  void add(const TPose2D& pose, double progress) {
    if (motions_.is_free_at(pose)) nodes_.push_back({pose, progress});
  }

  /// To turn where the initial heading is wrong.
  void add_around_start() {
    constexpr int kDirections = 8;
    for (const double distance : {1.0, 2.0})
      for (int i = 0; i < kDirections; ++i)
        for (int j = 0; j < kDirections; ++j) {
          const double angle = problem_.start_heading + 2 * M_PI * i / kDirections;
          const double r = distance * turning_radius();
          add({problem_.start.x + r * math::cos(angle), problem_.start.y + r * math::sin(angle),
               mrpt::math::wrapToPi(problem_.start_heading + 2 * M_PI * j / kDirections)},
              kAroundStart);
        }
  }

  void add_along_path(double radius) {
    std::string reason;
    const Occupancy& cells = problem_.world.occupancy();
    const auto exact = shortest_disc_path(cells, radius, problem_.start, problem_.goal, reason);
    if (!exact) return;
    constexpr double kMaxExcess = 1e-5, kCurveSpacing = 0.25, kStraightSpacing = 0.5;  // -, m, m
    const Path points = resample(to_polyline(*exact, cells, kMaxExcess),
                                 turning_radius() > 0 ? kCurveSpacing : kStraightSpacing);
    const double total = slalom::length(points);
    double traveled = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double leg = distance_between(points[i - 1], points[i]);
      traveled += leg;
      if (leg == 0) continue;
      const bool is_last = i + 1 == points.size();
      add({points[i].x, points[i].y,
           direction(points[i - 1], points[is_last || turning_radius() > 0 ? i : i + 1])},
          is_last ? kGoal : traveled / total);
    }
  }

  /// Finds the best free motion to node i, trying those first that would give the shortest path.
  void connect(std::size_t i) {
    constexpr double kMaxDistance = 2.5;  // m; farther poses are connected by smoothing
    Node& to = nodes_[i];
    std::vector<std::pair<double, int>> candidates;
    for (std::size_t j = 0; j < i && nodes_[j].progress < to.progress; ++j)
      if (std::isfinite(nodes_[j].cost) && distance_between(nodes_[j].pose, to.pose) < kMaxDistance)
        candidates.emplace_back(nodes_[j].cost + motions_.length(nodes_[j].pose, to.pose),
                                static_cast<int>(j));
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [cost, j] : candidates) {
      if (!motions_.is_free(node(j).pose, to.pose)) continue;
      to.cost = cost;
      to.parent = j;
      return;
    }
  }

  const PlanningProblem& problem_;
  const PoseMotions& motions_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<TPose2D> goal_poses(const PlanningProblem& problem, const PoseMotions& motions) {
  std::vector<TPose2D> poses;
  for (int i = 0; i < kGoalHeadings; ++i) {
    const TPose2D pose(problem.goal.x, problem.goal.y,
                       mrpt::math::wrapToPi(2 * M_PI * i / kGoalHeadings));
    if (motions.is_free_at(pose)) poses.push_back(pose);
  }
  return poses;
}

std::vector<TPose2D> path_on_roadmap(const PlanningProblem& problem, const PoseMotions& motions) {
  return Roadmap(problem, motions).shortest_path();
}

}  // namespace slalom
