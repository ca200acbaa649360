// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "measured_run.h"
#include "places.h"

#include <slalom/core/error.h>
#include <slalom/core/random.h>
#include <slalom/core/text.h>
#include <slalom/metrics/mover_metrics.h>

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>

namespace slalom::testing {
namespace {

/// The cells of a line of a Markdown table, in which \| is an escaped bar.
std::vector<std::string> table_cells(const std::string& line) {
  std::vector<std::string> cells(1);
  for (std::size_t i = 1; i < line.size(); ++i)
    if (line[i] == '|' && line[i - 1] != '\\')
      cells.emplace_back();
    else
      cells.back() += line[i];
  return cells;
}

std::vector<std::string> quoted_words(const std::string& text, char quote) {
  std::vector<std::string> words;
  for (auto begin = text.find(quote); begin != std::string::npos;
       begin = text.find(quote, begin + 1)) {
    const auto end = text.find(quote, begin + 1);
    words.push_back(text.substr(begin + 1, end - begin - 1));
    begin = end;
  }
  return words;
}

struct DocumentedMetric {
  std::string id, unit_and_direction, na;
};

/// The rows of the documentation's table of metrics.
std::vector<DocumentedMetric> documented_metrics() {
  std::ifstream file(kDocs + "/reference/definitions.md");
  std::vector<DocumentedMetric> metrics;
  std::string line;
  while (std::getline(file, line) && line != "## Metrics") continue;
  while (std::getline(file, line) && line.rfind("## ", 0) != 0) {
    if (line.rfind("| `", 0) != 0) continue;
    const auto cells = table_cells(line);
    for (const std::string& id : quoted_words(cells.at(0), '`'))
      metrics.push_back({id, cells.at(3), cells.at(5)});
  }
  return metrics;
}

/// Range as the documentation states it; "" for all from 0, and for all numbers.
std::string documented_range(const QuantityInfo& info) {
  const Range& range = info.range;
  if (info.is_rate()) return "0 or 1, ";
  if (range.is_bounded())
    return "[" + format_number(range.low) + ", " +
           (range.high == M_PI ? "pi" : format_number(range.high)) + "], ";
  if (range.bounded_above()) return "up to " + format_number(range.high) + ", ";
  return range.bounded_below() && range.low != 0 ? "from " + format_number(range.low) + ", " : "";
}

TEST(Metrics, AreListedInTheOrderOfTheDocumentation) {
  const std::vector<DocumentedMetric> documented = documented_metrics();
  ASSERT_EQ(all_metrics().size(), documented.size());
  std::set<std::string> ids;
  for (std::size_t i = 0; i < documented.size(); ++i) {
    const Metric& candidate = all_metrics()[i];
    const QuantityInfo& info = candidate.info;
    const std::string& text = documented[i].unit_and_direction;
    EXPECT_EQ(info.id, documented[i].id);
    EXPECT_NE((" " + text).find(" " + info.unit + ","), std::string::npos) << info.id << text;
    EXPECT_TRUE(ends_with(text, ", " + documented_range(info) + to_string(info.direction) + " "))
        << info.id << text;
    EXPECT_GE(info.version, 1) << info.id;
    EXPECT_NE(info.name, "") << info.id;
    const std::set<std::string> no_merits = {"contact_mover", "people_delay_floor",
                                             "people_overlap"};
    const bool is_no_merit = no_merits.count(info.id) > 0;
    EXPECT_EQ(info.direction == Direction::None, is_no_merit) << info.id;
    EXPECT_EQ(&metric(info.id), &candidate);
    EXPECT_TRUE(ids.insert(info.id).second) << "duplicate " << info.id;
  }
}

TEST(Metrics, OfRunsThatReachedTheGoalAreListedAsDocumented) {
  for (const DocumentedMetric& documented : documented_metrics())
    EXPECT_EQ(contains(reached_metric_ids(), documented.id),
              contains(split(documented.na, ';'), "reached"))
        << documented.id;
}

TEST(Metrics, RejectUnknownIdsWithTheMostSimilar) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "metric:", {"'optimalty'", "expected 'optimality'"},
                           [] { metric("optimalty"); }));
}

TEST(Metrics, GiveTheOutcomeAsReasonIfTheGoalWasNotReached) {
  MeasuredRun run({{2, 5}, {3, 5}});
  run.outcome = Outcome::Collision;
  for (const std::string id : {"optimality", "optimality_area", "safety", "safety_area", "optisafe",
                               "path_excess", "time_to_goal", "time_ratio"})
    EXPECT_EQ(run.reason(id), "outcome: collision") << id;
  for (const std::string id : {"soft_spl", "path_length", "min_clearance", "mean_clearance",
                               "risk_time_ratio", "inverse_clearance", "impact_speed", "progress",
                               "final_distance", "closest_distance", "mean_speed", "time_stopped"})
    EXPECT_FALSE(run.value(id).is_na()) << id;
}

TEST(Metrics, AreNaWithoutATrajectory) {
  const MeasuredRun run({});
  for (const Metric& candidate : all_metrics()) {
    const std::string& id = candidate.info.id;
    if (id == "success") continue;
    EXPECT_EQ(run.reason(id), id == "impact_speed" ? "outcome: success" : "no trajectory") << id;
  }
}

TEST(Metrics, GiveTheReasonOfAMissingReference) {
  MeasuredRun run({{2, 5}, {8, 5}});
  run.references = {};
  run.references.shortest_reason = "no path";
  run.references.safest_reason = "no diagram";
  for (const std::string id : {"optimality", "optimality_area", "spl", "soft_spl", "barn_score_v2",
                               "path_excess", "time_ratio", "progress"})
    EXPECT_EQ(run.reason(id), "no path") << id;
  run.set_shortest({{2, 5}, {8, 5}});
  for (const std::string id : {"safety", "safety_area", "optisafe"})
    EXPECT_EQ(run.reason(id), "no diagram") << id;
}

/// The integral of the distance to the segment from (2, 5) to (8, 5) along a path, computed in
/// small steps.
double area_to_straight_line(const Path& path) {
  constexpr int kSteps = 4000;
  double area = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double step = (path[i] - path[i - 1]).norm() / kSteps;
    for (int k = 0; k < kSteps; ++k) {
      const auto p = path[i - 1] + (path[i] - path[i - 1]) * ((k + 0.5) / kSteps);
      area += step * std::hypot(p.x - std::clamp(p.x, 2.0, 8.0), p.y - 5);
    }
  }
  return area;
}

TEST(Metrics, AreInTheirRangesOnRandomTrajectories) {
  RandomEngine random(1);
  for (int i = 0; i < 50; ++i) {
    Path points{{2, 5}};
    for (int k = uniform_int(random, 1, 20); k > 0; --k)
      points.emplace_back(uniform_real(random, 1, 9), uniform_real(random, 1, 9));
    points.emplace_back(8, 5);
    const MeasuredRun run(points);
    EXPECT_GT(run.number("optimality"), 0);
    EXPECT_LE(run.number("optimality"), 1 + 1e-12);
    EXPECT_NEAR(run.number("spl"), run.number("optimality"), 1e-12);
    EXPECT_NEAR(run.number("optimality_area"), area_to_straight_line(points) / 6, 1e-3);
    EXPECT_GE(run.number("path_length"), 6 - 1e-12);
    EXPECT_LE(run.number("min_clearance"), run.number("mean_clearance"));
    EXPECT_LE(run.number("safety"), 1 + 1e-12);  // y = 5 has the maximum clearance
  }
}

mrpt::math::TPoint2D any_point(RandomEngine& random) {
  return {uniform_real(random, 1, 9), uniform_real(random, 1, 9)};
}

Primitives random_discs(RandomEngine& random) {
  Primitives obstacles;
  for (int k = uniform_int(random, 0, 4); k > 0; --k)
    obstacles.discs.push_back({any_point(random), uniform_real(random, 0.1, 0.6)});
  return obstacles;
}

Movers random_movers(RandomEngine& random) {
  Movers movers;
  for (int k = uniform_int(random, 0, 3); k > 0; --k) {
    const double seconds = uniform_real(random, 1, 9);
    movers.push_back({std::to_string(k),
                      0.3,
                      {{0, any_point(random)}, {seconds, any_point(random)}},
                      MoverEnd::Stop});
  }
  return movers;
}

/// A run among discs and walkers with any speeds and end, which need not fit the poses.
struct RandomRun : MeasuredRun {
  explicit RandomRun(RandomEngine& random)
      : MeasuredRun({}, random_discs(random), random_movers(random)) {
    const int last = static_cast<int>(names_of<Outcome>().size()) - 1;
    if (uniform_int(random, 0, 1) == 0)
      outcome = static_cast<Outcome>(uniform_int(random, 0, last));
    const bool stands = uniform_int(random, 0, 3) == 0;
    const double step = stands ? 0 : 0.3;
    mrpt::math::TPoint2D at(2, 5);
    for (int k = uniform_int(random, 0, 60); k >= 0; --k) {
      Sample sample;
      sample.t = 0.1 * static_cast<double>(trajectory.samples.size());
      sample.pose = {at.x, at.y, uniform_real(random, -3, 3)};
      sample.v = sample.command_v = stands ? 0 : uniform_real(random, -1, 1);
      sample.w = sample.command_w = stands ? 0 : uniform_real(random, -1, 1);
      trajectory.samples.push_back(sample);
      at = {std::clamp(at.x + uniform_real(random, -0.5, 1) * step, 0.3, 9.0),
            std::clamp(at.y + uniform_real(random, -1, 1) * step, 0.3, 9.7)};
      if (world.distance_field().clearance(at) < robot.radius) outcome = Outcome::Collision;
    }
  }
};

TEST(Metrics, OfRandomRunsAreInTheRangesThatTheirRowsState) {
  constexpr double kRounding = 1e-9;
  RandomEngine random(1);
  std::map<std::string, int> numbers;
  for (int i = 0; i < 400; ++i) {
    const RandomRun run(random);
    for (const Metric& tested : all_metrics()) {
      const QuantityInfo& info = tested.info;
      const Value value = run.value(info.id);
      if (value.is_na()) continue;
      ++numbers[info.id];
      EXPECT_GE(value.number(), info.range.low - kRounding) << info.id;
      EXPECT_LE(value.number(), info.range.high + kRounding) << info.id;
      if (info.is_rate() || info.kind == QuantityKind::Count) {
        EXPECT_EQ(value.number(), std::round(value.number())) << info.id;
      }
    }
  }
  // There are neither people nor an earliest arrival, and the goal has no heading.
  for (const std::string& id : metric_ids())
    EXPECT_TRUE(numbers[id] > 0 || id == "arrival_ratio" || id == "goal_heading_error" ||
                contains(people_metric_ids(), id))
        << id << " was never computed";
}

TEST(Metrics, HaveTheKindThatTheirUnitSays) {
  for (const Metric& metric : all_metrics()) {
    const QuantityInfo& info = metric.info;
    const bool without_unit = info.kind == QuantityKind::Rate || info.kind == QuantityKind::Ratio ||
                              info.kind == QuantityKind::Score;
    EXPECT_EQ(without_unit, info.unit == "-" && info.id != "contact_mover") << info.id;
    if (info.is_rate()) {
      EXPECT_EQ(range_notation(info.range), "0..1") << info.id;
    }
  }
}

TEST(Metrics, WithoutRangeAreClearancesDelaysOfPeopleAndALogarithm) {
  std::set<std::string> unbounded;
  for (const Metric& metric : all_metrics())
    if (range_notation(metric.info.range) == "..") unbounded.insert(metric.info.id);
  EXPECT_EQ(unbounded,
            (std::set<std::string>{"log_dimensionless_jerk", "mean_clearance", "min_clearance",
                                   "min_mover_clearance", "people_deficit", "people_delay",
                                   "people_hindrance"}));
}

}  // namespace
}  // namespace slalom::testing
