#include "reference_worlds.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// Answers with a fixed path.
class FixedPlanner : public ReferencePlanner {
 public:
  explicit FixedPlanner(std::optional<Path> path) : path_(std::move(path)) {}
  std::string name() const override { return "Fixed"; }
  std::optional<Path> plan(const PlanningProblem&, const References&,
                           std::uint64_t) const override {
    return path_;
  }

 private:
  std::optional<Path> path_;
};

References consult(const World& world, std::optional<Path> path) {
  const FixedPlanner planner(std::move(path));
  return compute_references(problem_of(world, 0.25), &planner, 0.01, 1);
}

TEST(References, APlannersPathIsUsedWhenItKeepsTheGap) {
  const World world = empty_world(10, {1, 5}, {9, 5});
  // 8 m straight; by way of (5, 5.3): 2 * |(4, 0.3)| = 8.0225, within 1 %.
  const References references = consult(world, Path{{1, 5}, {5, 5.3}, {9, 5}});
  ASSERT_TRUE(references.shortest.has_value());
  EXPECT_EQ(references.shortest->planner, "Fixed");
  EXPECT_NEAR(references.shortest->length, 8.0225, 1e-4);
  EXPECT_EQ(references.shortest->certificate.upper_bound, 8);
  EXPECT_EQ(references.shortest->note, "");
}

TEST(References, APlannersPathThatIsTooLongIsNotUsedAndThatIsSaid) {
  const World world = empty_world(10, {1, 5}, {9, 5});
  const References references = consult(world, Path{{1, 5}, {5, 7}, {9, 5}});
  ASSERT_TRUE(references.shortest.has_value());
  EXPECT_EQ(references.shortest->planner, "exact");
  EXPECT_EQ(references.shortest->note, "Fixed came to 8.9443 m, not within the gap of 0.01");
}

TEST(References, APlannersPathThatIsNotFreeOrMissingIsNotUsed) {
  const World world = walled_world(10, 1.2);
  EXPECT_EQ(consult(world, Path{{1, 2}, {9, 2}}).shortest->note,
            "Fixed gave a path that is not free");
  EXPECT_EQ(consult(world, std::nullopt).shortest->note, "Fixed found no path");
}

/// Answers with a fixed path when it is asked for the safest one.
class FixedSafestPlanner : public FixedPlanner {
 public:
  using FixedPlanner::FixedPlanner;
  Objective objective() const override { return Objective::Clearance; }
};

TEST(References, APlannerOfSafePathsProvidesTheSafestOne) {
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
  EXPECT_EQ(narrow.note, "Fixed came to a bottleneck of 0.5000 m, not within the gap of 0.01");
}

TEST(References, BothTheExactAndThePlannersLengthAreKept) {
  const World world = empty_world(10, {1, 5}, {9, 5});
  const References references = consult(world, Path{{1, 5}, {5, 7}, {9, 5}});
  EXPECT_EQ(references.shortest->exact_length, 8);
  ASSERT_TRUE(references.shortest->planner_length.has_value());
  EXPECT_NEAR(*references.shortest->planner_length, 8.9443, 1e-4);
  EXPECT_FALSE(consult(world, std::nullopt).shortest->planner_length.has_value());
}

TEST(References, WithoutAPathBothReasonsAreGiven) {
  const References references =
      compute_references(problem_of(walled_world(10, 0.3), 0.25), nullptr, 0.01, 1);
  EXPECT_FALSE(references.shortest.has_value());
  EXPECT_FALSE(references.safest.has_value());
  EXPECT_FALSE(references.shortest_reason.empty());
  EXPECT_FALSE(references.safest_reason.empty());
}

TEST(IsFree, JudgesEverySegmentForTheWholeDisc) {
  const World world = walled_world(10, 1.2);
  EXPECT_TRUE(is_free(world, {{1, 2}, {4.5, 2}}, 0.25));
  EXPECT_FALSE(is_free(world, {{1, 2}, {4.8, 2}}, 0.25));  // the wall begins at 4.9
  EXPECT_FALSE(is_free(world, {{1, 2}, {9, 2}}, 0.25));
  EXPECT_FALSE(is_free(world, {{0.2, 5}}, 0.25));
  EXPECT_FALSE(is_free(world, {}, 0.25));
}

}  // namespace
}  // namespace slalom
