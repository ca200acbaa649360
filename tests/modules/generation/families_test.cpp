#include "family_samples.h"

#include <slalom/generation/ends.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/references/exact_shortest.h>

#include <cmath>

namespace slalom {
namespace {

constexpr double kPi = 3.14159265358979323846;

class Families : public testing::TestWithParam<std::string> {
 protected:
  static std::vector<GeneratedScenario> made(const std::string& name, const GenerationTask& task,
                                             double length_scale = 1) {
    MixTask mix;
    mix.each = task;
    std::vector<GeneratedScenario> all;
    const auto progress = make_silent_progress();
    generate_mix({{family(name, "", with_hall(length_scale)), 1, task.seed, name}}, mix, *progress,
                 [&](std::vector<GeneratedScenario>& part) {
                   for (GeneratedScenario& one : part) all.push_back(std::move(one));
                   return std::vector<std::size_t>();
                 });
    return all;
  }

  static GenerationTask task(int count, std::uint64_t seed, double robot_radius = 0.25) {
    GenerationTask task;
    task.count = count;
    task.seed = seed;
    task.robot_radius = robot_radius;
    return task;
  }
};

TEST_P(Families, TheSameSeedDrawsTheSameAndAnotherSeedAnother) {
  const auto generator = family(GetParam());
  const auto drawn = [&](std::uint64_t seed) {
    RandomEngine engine(seed);
    return generator->generate("x", engine).hash();
  };
  EXPECT_EQ(drawn(1), drawn(1));
  EXPECT_NE(drawn(1), drawn(2));
  EXPECT_EQ(generator->name(), GetParam());
}

TEST_P(Families, EveryScenarioIsSolvableForRobotsOfSeveralSizes) {
  for (const double radius : {0.1, 0.25, 0.35})
    for (const GeneratedScenario& one : made(GetParam(), task(3, 11, radius))) {
      const World world(one.scenario, 0.05);
      const auto& start = one.scenario.start();
      std::string reason;
      EXPECT_TRUE(
          exact_shortest_path({world, radius, {start.x, start.y}, one.scenario.goal()}, 1, reason))
          << one.scenario.name() << ": " << reason;
    }
}

TEST_P(Families, AnEngineOfTheSeedThatIsToldDrawsTheScenarioAgain) {
  const auto generator = family(GetParam());
  for (const GeneratedScenario& one : made(GetParam(), task(3, 5))) {
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
    EXPECT_GT(heading, -kPi);
    EXPECT_LE(heading, kPi);
  }
}

TEST_P(Families, StartAndGoalKeepTheirDistance) {
  const auto generator = family(GetParam(), "min_distance = 5.5\n");
  RandomEngine engine(9);
  for (int i = 0; i < 20; ++i) {
    const Scenario s = generator->generate("x", engine);
    EXPECT_GE(std::hypot(s.goal().x - s.start().x, s.goal().y - s.start().y), 5.5);
  }
}

TEST_P(Families, ScaledByTheRobotSolvabilityScalesToo) {
  // A robot twice as large in places twice as large.
  EXPECT_EQ(made(GetParam(), task(2, 4, 0.5), 2).size(), 2U);
}

TEST_P(Families, AFloorThatIsTooSmallIsRefused) {
  EXPECT_EQ(refusal(GetParam(), "min_distance = 5000\n")
                .find("g.ini:" +
                      std::string(GetParam() == "crop" || GetParam() == "clutter" ? "3" : "2") +
                      ": [generator." + GetParam() + "] min_distance: start and goal cannot be"),
            0U)
      << refusal(GetParam(), "min_distance = 5000\n");
}

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(generator_names()),
                         [](const auto& info) { return info.param; });

TEST(ScaledFamily, AllLengthsAreMultiplied) {
  // The same random numbers in a world of another scale: the same picture, larger.
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

TEST(WrapAngle, LeavesWhatIsInRangeAndTurnsTheRest) {
  EXPECT_EQ(wrap_angle(3), 3);
  EXPECT_EQ(wrap_angle(kPi), kPi);
  EXPECT_EQ(wrap_angle(-kPi), kPi);
  EXPECT_NEAR(wrap_angle(4), 4 - 2 * kPi, 1e-15);
  EXPECT_NEAR(wrap_angle(-4), 2 * kPi - 4, 1e-15);
}

TEST(Ends, WithoutAGoodPlaceTheyAreOppositeCorners) {
  RandomEngine engine(1);
  EndsOptions options;
  options.margin = 0.5;
  const Ends ends = draw_ends(engine, {1, 2, 11, 12}, options, [](const auto&) { return false; });
  EXPECT_EQ(ends.start, mrpt::math::TPoint2D(1.5, 2.5));
  EXPECT_EQ(ends.goal, mrpt::math::TPoint2D(10.5, 11.5));
}

}  // namespace
}  // namespace slalom
