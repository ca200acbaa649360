// SPDX-License-Identifier: BSD-3-Clause
#include "departure.h"

#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/falsification/clusters.h>
#include <slalom/scenario/touched_mover.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace slalom {
namespace {

/// `bearing`: rad, from the heading, in either direction.
ObstacleSide side_of(double bearing) {
  if (std::abs(bearing) <= M_PI / 4) return ObstacleSide::Front;
  return std::abs(bearing) < 3 * M_PI / 4 ? ObstacleSide::Side : ObstacleSide::Back;
}

using Members = std::vector<std::size_t>;

/// Divides failures by their facts in words.
class Divider {
 public:
  explicit Divider(const std::vector<FailureFacts>& failures) {
    for (const FailureFacts& facts : failures) words_.push_back(facts_in_words(facts));
  }

  std::vector<FailureCluster> clusters() {
    std::map<std::string, Members> by_outcome;
    for (std::size_t i = 0; i < words_.size(); ++i) by_outcome[words_[i].front()].push_back(i);
    for (const auto& [outcome, members] : by_outcome) divide(members, 1);
    std::sort(clusters_.begin(), clusters_.end(), [](const auto& a, const auto& b) {
      if (a.members.size() != b.members.size()) return a.members.size() > b.members.size();
      return a.name != b.name ? a.name < b.name : a.members < b.members;
    });
    return std::move(clusters_);
  }

 private:
  std::vector<std::vector<std::string>> words_;
  std::vector<FailureCluster> clusters_;

  void divide(const Members& members, std::size_t fact) {
    if (fact == words_[members.front()].size()) {
      clusters_.push_back({name_of(members), members});
      return;
    }
    std::map<std::string, Members> by_value;
    for (const std::size_t member : members) by_value[words_[member][fact]].push_back(member);
    Members rest;
    for (auto value = by_value.begin(); value != by_value.end();) {
      const Members& having = value->second;
      if (having.size() < kMinCluster) {
        rest.insert(rest.end(), having.begin(), having.end());
        value = by_value.erase(value);
      } else {
        ++value;
      }
    }
    if (!rest.empty() && rest.size() < kMinCluster) return divide(members, fact + 1);
    for (const auto& [value, having] : by_value) divide(having, fact + 1);
    std::sort(rest.begin(), rest.end());
    if (!rest.empty()) divide(rest, fact + 1);
  }

  std::string name_of(const Members& members) const {
    std::vector<std::string> shared;
    const std::vector<std::string>& first = words_[members.front()];
    for (std::size_t fact = 0; fact < first.size(); ++fact)
      if (std::all_of(members.begin(), members.end(),
                      [&](std::size_t i) { return words_[i][fact] == first[fact]; }))
        shared.push_back(first[fact]);
    return join(shared, ", ");
  }
};

}  // namespace

FailureFacts measure_end(const World& world, const Movers& movers, const RobotModel& robot,
                         Outcome outcome, const Trajectory& trajectory) {
  const mrpt::math::TPose2D& pose = trajectory.samples.back().pose;
  const mrpt::math::TPoint2D& goal = world.scenario().goal();
  FailureFacts facts;
  facts.outcome = outcome;
  const double radius = robot.shape().enclosing_radius();
  const Mover* mover = outcome != Outcome::Collision
                           ? nullptr
                           : touched_mover(world, movers, mrpt::math::TPoint2D(pose), radius,
                                           robot.shape().corners_at(pose), trajectory.duration());
  facts.with_person = mover != nullptr && static_cast<std::size_t>(mover - movers.data()) >=
                                              world.scenario().movers().size();
  facts.with_mover = mover != nullptr && !facts.with_person;
  facts.side = side_of(mover != nullptr ? bearing_of(mover->position(trajectory.duration()), pose)
                                        : bearing_of_obstacle(world, pose, radius / 2));
  facts.motion = end_motion(outcome, trajectory, robot.shape().enclosing_radius(), robot.max_v);
  facts.faces_goal = std::abs(bearing_of(goal, pose)) <= M_PI / 2;
  return facts;
}

std::vector<std::string> facts_in_words(const FailureFacts& facts) {
  const char* obstacles = facts.obstacles <= 1   ? "at most 1 obstacle needed"
                          : facts.obstacles <= 3 ? "2 to 3 obstacles needed"
                                                 : "more than 3 obstacles needed";
  const char* with = facts.with_person  ? " with a person"
                     : facts.with_mover ? " with a moving obstacle"
                                        : "";
  const char* bottleneck = facts.bottleneck_width < 2   ? "bottleneck below 2 robot widths"
                           : facts.bottleneck_width < 4 ? "bottleneck of 2 to 4 robot widths"
                                                        : "bottleneck of at least 4 robot widths";
  return {to_string(facts.outcome) + with,
          to_string(facts.side),
          to_string(facts.motion),
          facts.faces_goal ? "faces the goal" : "faces away from the goal",
          obstacles,
          bottleneck};
}

std::vector<FailureCluster> cluster_failures(const std::vector<FailureFacts>& failures) {
  return Divider(failures).clusters();
}

}  // namespace slalom
