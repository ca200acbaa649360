#include "error_text.h"
#include "measured_run.h"

#include <slalom/core/error.h>
#include <slalom/core/random.h>
#include <slalom/core/text.h>

#include <gtest/gtest.h>

#include <fstream>
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
  std::string id, unit_and_direction;
};

/// The rows of the documentation's table of metrics.
std::vector<DocumentedMetric> documented_metrics() {
  std::ifstream file(SLALOM_DOCS "/definitions.md");
  std::vector<DocumentedMetric> metrics;
  std::string line;
  while (std::getline(file, line) && line != "## Metrics") continue;
  while (std::getline(file, line) && line.rfind("## ", 0) != 0) {
    if (line.rfind("| `", 0) != 0) continue;
    const auto cells = table_cells(line);
    for (const std::string& id : quoted_words(cells.at(0), '`'))
      metrics.push_back({id, cells.at(3)});
  }
  return metrics;
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
    EXPECT_TRUE(ends_with(text, ", " + to_string(info.direction) + " ")) << info.id << text;
    EXPECT_GE(info.version, 1) << info.id;
    EXPECT_NE(info.name, "") << info.id;
    EXPECT_EQ(info.direction == Direction::None, info.id == "contact_mover") << info.id;
    EXPECT_EQ(&metric(info.id), &candidate);
    EXPECT_TRUE(ids.insert(info.id).second) << "duplicate " << info.id;
  }
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

}  // namespace
}  // namespace slalom::testing
