// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "reference_worlds.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// Returns a fixed path.
class FixedPlanner : public ReferencePlanner {
 public:
  explicit FixedPlanner(std::optional<Path> path) : path_(std::move(path)) {}
  std::string name() const override { return "Fixed"; }
  std::optional<Path> plan(const PlanningProblem&, const References&, std::uint64_t,
                           std::string&) const override {
    return path_;
  }

 private:
  std::optional<Path> path_;
};

References query_planner(const World& world, std::optional<Path> path) {
  const FixedPlanner planner(std::move(path));
  return compute_references(problem_of(world, 0.25), &planner, 0.01, 1);
}

TEST(References, PlannersPathIsUsedIfWithinTheGap) {
  const World world = empty_world(10, {1, 5}, {9, 5});
  // 8 m straight; via (5, 5.3): 2 * |(4, 0.3)| = 8.0225, within 1 %.
  const References references = query_planner(world, Path{{1, 5}, {5, 5.3}, {9, 5}});
  ASSERT_TRUE(references.shortest.has_value());
  EXPECT_EQ(references.shortest->planner, "Fixed");
  EXPECT_NEAR(references.shortest->length, 8.0225, 1e-4);
  EXPECT_EQ(references.shortest->certificate.upper_bound, 8);
  EXPECT_EQ(references.shortest->note, "");
}

TEST(References, PlannersPathThatIsTooLongIsNotUsedWithANote) {
  const World world = empty_world(10, {1, 5}, {9, 5});
  const References references = query_planner(world, Path{{1, 5}, {5, 7}, {9, 5}});
  ASSERT_TRUE(references.shortest.has_value());
  EXPECT_EQ(references.shortest->planner, "exact");
  EXPECT_TRUE(mentions(references.shortest->note, {"Fixed", "8.9443 m", "gap of 0.01"}));
}

TEST(References, PlannersPathThatIsNotFreeOrMissingIsNotUsed) {
  const World world = walled_world(10, 1.2);
  const std::string not_free = query_planner(world, Path{{1, 2}, {9, 2}}).shortest->note;
  EXPECT_TRUE(mentions(not_free, {"Fixed", "not free"}));
  const std::string missing = query_planner(world, std::nullopt).shortest->note;
  EXPECT_TRUE(mentions(missing, {"Fixed", "no path"}));
}

/// Returns a fixed path for the safest one.
class FixedSafestPlanner : public FixedPlanner {
 public:
  using FixedPlanner::FixedPlanner;
  Objective objective() const override { return Objective::Clearance; }
};

TEST(References, PlannerForClearanceProvidesTheSafestPath) {
  const World world = empty_world(10, {1, 5}, {9, 5});
  const auto safest_of = [&world](const Path& path) {
    const FixedSafestPlanner planner(path);
    return *compute_references(problem_of(world, 0.25), &planner, 0.01, 1).safest;
  };
  // Start and goal are 1 m from a wall: no path can have a wider bottleneck.
  const SafestPath good = safest_of({{1, 5}, {9, 5}});
  EXPECT_EQ(good.planner, "Fixed");
  EXPECT_NEAR(good.bottleneck, 1, 1e-9);
  const SafestPath narrow = safest_of({{1, 5}, {5, 0.5}, {9, 5}});
  EXPECT_EQ(narrow.planner, "exact");
  EXPECT_TRUE(mentions(narrow.note, {"Fixed", "bottleneck of 0.5000 m", "gap of 0.01"}));
}

TEST(References, ExactAndPlannersLengthAreBothStored) {
  const World world = empty_world(10, {1, 5}, {9, 5});
  const References references = query_planner(world, Path{{1, 5}, {5, 7}, {9, 5}});
  EXPECT_EQ(references.shortest->exact_length, 8);
  ASSERT_TRUE(references.shortest->planner_length.has_value());
  EXPECT_NEAR(*references.shortest->planner_length, 8.9443, 1e-4);
  EXPECT_FALSE(query_planner(world, std::nullopt).shortest->planner_length.has_value());
}

TEST(References, HaveBothReasonsWithoutAPath) {
  const References references =
      compute_references(problem_of(walled_world(10, 0.3), 0.25), nullptr, 0.01, 1);
  EXPECT_FALSE(references.shortest.has_value());
  EXPECT_FALSE(references.safest.has_value());
  EXPECT_FALSE(references.shortest_reason.empty());
  EXPECT_FALSE(references.safest_reason.empty());
}

TEST(IsFree, ChecksAllSegmentsForTheCompleteDisc) {
  const World world = walled_world(10, 1.2);
  EXPECT_TRUE(is_free(world, {{1, 2}, {4.5, 2}}, 0.25));
  EXPECT_FALSE(is_free(world, {{1, 2}, {4.8, 2}}, 0.25));  // the wall begins at 4.9
  EXPECT_FALSE(is_free(world, {{1, 2}, {9, 2}}, 0.25));
  EXPECT_FALSE(is_free(world, {{0.2, 5}}, 0.25));
  EXPECT_FALSE(is_free(world, {}, 0.25));
}

}  // namespace
}  // namespace slalom
