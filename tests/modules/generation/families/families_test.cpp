// SPDX-License-Identifier: BSD-3-Clause
#include "family_samples.h"

#include <slalom/generation/generate_mix.h>
#include <slalom/generation/start_goal.h>
#include <slalom/references/exact_shortest.h>

#include <cmath>

namespace slalom {
namespace {

class Families : public testing::TestWithParam<std::string> {
 protected:
  static std::vector<GeneratedScenario> generated(const std::string& name,
                                                  const GenerationSettings& settings,
                                                  double length_scale = 1) {
    MixSettings mix;
    mix.each = settings;
    std::vector<GeneratedScenario> all;
    const auto progress = make_silent_progress();
    generate_mix({{family(name, "", with_hall(length_scale)), 1, settings.seed, name}}, mix,
                 *progress, [&](std::vector<GeneratedScenario>& batch) {
                   for (GeneratedScenario& one : batch) all.push_back(std::move(one));
                   return std::vector<std::size_t>();
                 });
    return all;
  }

  static GenerationSettings settings(int count, std::uint64_t seed, double robot_radius = 0.25) {
    GenerationSettings settings;
    settings.count = count;
    settings.seed = seed;
    settings.robot_radius = robot_radius;
    return settings;
  }
};

TEST_P(Families, EqualSeedsGiveEqualScenariosAndOtherSeedsOthers) {
  const auto generator = family(GetParam());
  const auto drawn = [&](std::uint64_t seed) {
    RandomEngine engine(seed);
    return generator->generate("x", engine).hash();
  };
  EXPECT_EQ(drawn(1), drawn(1));
  EXPECT_NE(drawn(1), drawn(2));
  EXPECT_EQ(generator->name(), GetParam());
}

TEST_P(Families, ScenariosAreSolvableForRobotsOfSeveralSizes) {
  for (const double radius : {0.1, 0.25, 0.35})
    for (const GeneratedScenario& one : generated(GetParam(), settings(3, 11, radius))) {
      const World world(one.scenario, 0.05);
      const auto& start = one.scenario.start();
      std::string reason;
      EXPECT_TRUE(
          exact_shortest_path({world, radius, {start.x, start.y}, one.scenario.goal()}, reason))
          << one.scenario.name() << ": " << reason;
    }
}

TEST_P(Families, TheReportedSeedReproducesTheScenario) {
  const auto generator = family(GetParam());
  for (const GeneratedScenario& one : generated(GetParam(), settings(3, 5))) {
    RandomEngine engine(one.seed.value());
    EXPECT_EQ(generator->generate("again", engine).hash(), one.scenario.hash());
    EXPECT_EQ(one.generator, GetParam());
  }
}

TEST_P(Families, HeadingsAreWrapped) {
  const auto generator = family(GetParam());
  RandomEngine engine(3);
  for (int i = 0; i < 40; ++i) {
    const double heading = generator->generate("x", engine).start().phi;
    EXPECT_GT(heading, -M_PI);
    EXPECT_LE(heading, M_PI);
  }
}

TEST_P(Families, StartAndGoalAreAtLeastMinDistanceApart) {
  const auto generator = family(GetParam(), "min_distance = 5.5\n");
  RandomEngine engine(9);
  for (int i = 0; i < 20; ++i) {
    const Scenario s = generator->generate("x", engine);
    EXPECT_GE(std::hypot(s.goal().x - s.start().x, s.goal().y - s.start().y), 5.5);
  }
}

TEST_P(Families, ScaledScenariosAreSolvableForScaledRobots) {
  // Twice the robot radius in scenarios of twice the size.
  EXPECT_EQ(generated(GetParam(), settings(2, 4, 0.5), 2).size(), 2U);
}

TEST_P(Families, RejectsAWorkspaceSmallerThanMinDistance) {
  EXPECT_EQ(refusal(GetParam(), "min_distance = 5000\n")
                .find("g.ini:" +
                      std::string(GetParam() == "crop" || GetParam() == "clutter" ? "3" : "2") +
                      ": [generator." + GetParam() + "] min_distance: start and goal cannot be"),
            0U)
      << refusal(GetParam(), "min_distance = 5000\n");
}

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(generator_names()),
                         [](const auto& family) { return family.param; });

TEST(ScaledFamily, ScalesAllLengths) {
  // The same random numbers at another scale give the same scenario, scaled.
  for (const std::string name : {"random", "poisson_forest", "rooms", "maze", "traps"}) {
    RandomEngine one(8), other(8);
    const Scenario small = family(name)->generate("x", one);
    const Scenario large = family(name, "", with_hall(2))->generate("x", other);
    EXPECT_NEAR(large.bounds().x_max, 2 * small.bounds().x_max, 1e-9) << name;
    EXPECT_NEAR(large.goal().x, 2 * small.goal().x, 1e-9) << name;
    EXPECT_NEAR(large.goal().y, 2 * small.goal().y, 1e-9) << name;
    EXPECT_EQ(large.primitives().discs.size(), small.primitives().discs.size()) << name;
    EXPECT_EQ(large.primitives().polygons.size(), small.primitives().polygons.size()) << name;
  }
}

TEST(WrapAngle, LeavesAnglesInRangeUnchangedAndWrapsOthers) {
  EXPECT_EQ(wrap_angle(3), 3);
  EXPECT_EQ(wrap_angle(M_PI), M_PI);
  EXPECT_EQ(wrap_angle(-M_PI), M_PI);
  EXPECT_NEAR(wrap_angle(4), 4 - 2 * M_PI, 1e-15);
  EXPECT_NEAR(wrap_angle(-4), 2 * M_PI - 4, 1e-15);
}

TEST(StartGoal, WithoutAValidPositionTheyAreOppositeCorners) {
  RandomEngine engine(1);
  StartGoalOptions options;
  options.margin = 0.5;
  const StartGoal start_goal =
      sample_start_goal(engine, {1, 2, 11, 12}, options, [](const auto&) { return false; });
  EXPECT_EQ(start_goal.start, mrpt::math::TPoint2D(1.5, 2.5));
  EXPECT_EQ(start_goal.goal, mrpt::math::TPoint2D(10.5, 11.5));
}

}  // namespace
}  // namespace slalom
