// SPDX-License-Identifier: BSD-3-Clause
#include "common_facts.h"

#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/metrics/metric.h>
#include <slalom/results/result_table.h>
#include <slalom/trajectory/end_motion.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr std::size_t kFewestAlike = 3;
constexpr double kGoalRadii = 8, kStartRadii = 4, kOpenRadii = 1, kCloseRadii = 0.5;

double path_length(const Trajectory& trajectory) {
  double length = 0;
  for (std::size_t i = 1; i < trajectory.samples.size(); ++i)
    length += math::hypot(trajectory.samples[i].pose.x - trajectory.samples[i - 1].pose.x,
                          trajectory.samples[i].pose.y - trajectory.samples[i - 1].pose.y);
  return length;
}

}  // namespace

CommonFacts::CommonFacts(std::size_t methods, const RobotModel& robot)
    : robot_(robot), radius_(robot.shape().enclosing_radius()), counts_(methods) {}

void CommonFacts::add(std::size_t method, const ScenarioRuns& content, const World& world,
                      std::size_t i) {
  if (!is_failure(content.records[i].outcome)) return;
  Counts& counts = counts_[method];
  ++counts.failures;
  const Trajectory& trajectory = content.trajectories[i];
  if (trajectory.samples.empty()) return;
  const double clearance =
      footprint_clearance(world, robot_.shape(), trajectory.samples.back().pose);
  for (std::size_t fact = 0; fact < kFailureFacts; ++fact)
    if (holds(static_cast<FailureFact>(fact), content, i, clearance)) ++counts.facts[fact];
}

bool CommonFacts::holds(FailureFact fact, const ScenarioRuns& content, std::size_t i,
                        double clearance) const {
  const Trajectory& trajectory = content.trajectories[i];
  const auto& end = trajectory.samples.back().pose;
  const auto outcome = from_name<Outcome>(content.records[i].outcome);
  const EndMotion motion =
      end_motion(outcome.value_or(Outcome::Stuck), trajectory, radius_, robot_.max_v);
  const auto& goal = content.content.goal();
  switch (fact) {
    case FailureFact::NearGoal:
      return math::hypot(end.x - goal.x, end.y - goal.y) <= kGoalRadii * radius_;
    case FailureFact::AtStart:
      return path_length(trajectory) < kStartRadii * radius_;
    case FailureFact::Turning:
      return motion == EndMotion::Turning;
    case FailureFact::Wandering:
      return content.references.shortest &&
             path_length(trajectory) > 2 * content.references.shortest->length;
    case FailureFact::Apart:
      return motion == EndMotion::Stopped && clearance >= kOpenRadii * radius_;
    case FailureFact::AtObstacle:
      return motion == EndMotion::Stopped && clearance < kCloseRadii * radius_;
  }
  return false;
}

std::string CommonFacts::text_of(FailureFact fact) const {
  const auto meters = [this](double radii) {
    return format_number(std::round(100 * radii * radius_) / 100) + " m";
  };
  switch (fact) {
    case FailureFact::NearGoal:
      return "end within " + meters(kGoalRadii) + " of the goal";
    case FailureFact::AtStart:
      return "hardly leave the start: less than " + meters(kStartRadii) + " driven";
    case FailureFact::Turning:
      return "turn in place at their end: does it see what it turns to?";
    case FailureFact::Wandering:
      return "wander: more than twice the reference path";
    case FailureFact::Apart:
      return "stop " + meters(kOpenRadii) + " or more from every static obstacle";
    case FailureFact::AtObstacle:
      return "stop less than " + meters(kCloseRadii) + " from a static obstacle";
  }
  return "";
}

std::optional<CommonFacts::Common> CommonFacts::of(std::size_t method) const {
  const Counts& own = counts_[method];
  constexpr auto kTurning = static_cast<std::size_t>(FailureFact::Turning);
  std::optional<std::size_t> distinctive, frequent;
  double most = 0.2;
  for (std::size_t fact = 0; fact < kFailureFacts; ++fact) {
    const std::size_t count = own.facts[fact];
    if (count < kFewestAlike || 2 * count < own.failures) continue;
    if (fact == kTurning) {
      distinctive = fact;
      break;
    }
    std::size_t others = 0, of_others = 0;
    for (const Counts& counts : counts_) {
      others += counts.failures;
      of_others += counts.facts[fact];
    }
    others -= own.failures;
    of_others -= count;
    const double share = static_cast<double>(count) / static_cast<double>(own.failures);
    const double excess =
        others == 0 ? 0 : share - static_cast<double>(of_others) / static_cast<double>(others);
    if (excess >= most) most = excess, distinctive = fact;
    if (share >= 0.8 && (!frequent || count > own.facts[*frequent])) frequent = fact;
  }
  const std::optional<std::size_t> chosen = distinctive ? distinctive : frequent;
  if (!chosen) return std::nullopt;
  const auto fact = static_cast<FailureFact>(*chosen);
  return Common{fact, own.facts[*chosen], own.failures, text_of(fact)};
}

}  // namespace slalom
