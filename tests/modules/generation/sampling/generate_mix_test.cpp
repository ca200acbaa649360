// SPDX-License-Identifier: BSD-3-Clause
#include "family_samples.h"

#include <slalom/generation/generate_mix.h>

namespace slalom {
namespace {

struct Mixed {
  std::vector<std::string> names, hashes, generators;
  std::vector<std::size_t> batches;
};

std::vector<WeightedGenerator> sample_mix() {
  return {{family("random"), 2, 7, "random"},
          {family("poisson_forest"), 1, 8, "poisson_forest"},
          {family("traps"), 1, 9, "traps"}};
}

Mixed mixed(const MixSettings& settings, const std::vector<WeightedGenerator>& mix = sample_mix()) {
  Mixed result;
  const auto progress = make_silent_progress();
  generate_mix(mix, settings, *progress, [&](std::vector<GeneratedScenario>& batch) {
    result.batches.push_back(batch.size());
    for (const GeneratedScenario& one : batch) {
      result.names.push_back(one.scenario.name());
      result.hashes.push_back(one.scenario.hash());
      result.generators.push_back(one.generator);
    }
    return std::vector<std::size_t>();
  });
  return result;
}

MixSettings settings_of(int count, int jobs = 1) {
  MixSettings settings;
  settings.each.count = count;
  settings.jobs = jobs;
  return settings;
}

TEST(GenerateMix, TheResultDoesNotDependOnTheNumberOfThreads) {
  const Mixed serial = mixed(settings_of(150));
  for (const int jobs : {2, 5}) {
    const Mixed parallel = mixed(settings_of(150, jobs));
    EXPECT_EQ(parallel.names, serial.names);
    EXPECT_EQ(parallel.hashes, serial.hashes);
  }
}

TEST(GenerateMix, HeadingsOfGoalsChangeNothingElse) {
  MixSettings settings = settings_of(40);
  std::vector<Scenario> plain, headed;
  for (const bool headings : {false, true}) {
    settings.each.goal_headings = headings;
    const auto progress = make_silent_progress();
    generate_mix(sample_mix(), settings, *progress, [&](std::vector<GeneratedScenario>& batch) {
      for (const GeneratedScenario& one : batch)
        (headings ? headed : plain).push_back(one.scenario);
      return std::vector<std::size_t>();
    });
  }
  std::set<double> distinct;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_FALSE(plain[i].goal_heading());
    ASSERT_TRUE(headed[i].goal_heading());
    EXPECT_LE(std::abs(*headed[i].goal_heading()), M_PI);
    distinct.insert(*headed[i].goal_heading());
    EXPECT_EQ(headed[i].with_goal_heading(std::nullopt).hash(), plain[i].hash());
  }
  EXPECT_EQ(distinct.size(), 40U);
}

TEST(GenerateMix, GeneratorsAreMixedByTheirWeights) {
  const Mixed eight = mixed(settings_of(8));
  const std::vector<std::string>& g = eight.generators;
  EXPECT_EQ(std::count(g.begin(), g.end(), "random"), 4);
  EXPECT_EQ(std::count(g.begin(), g.end(), "poisson_forest"), 2);
  EXPECT_EQ(std::count(g.begin(), g.end(), "traps"), 2);
  EXPECT_EQ(eight.names[0], "random_0000");
}

TEST(GenerateMix, ScenariosOfAGeneratorDoNotDependOnTheOthers) {
  const Mixed all = mixed(settings_of(8));
  const Mixed alone = mixed(settings_of(2), {sample_mix()[2]});
  std::vector<std::string> traps;
  for (std::size_t i = 0; i < 8; ++i)
    if (all.generators[i] == "traps") traps.push_back(all.hashes[i]);
  EXPECT_EQ(traps, alone.hashes);
}

TEST(GenerateMix, ALargerCountExtendsTheSameSequence) {
  const Mixed few = mixed(settings_of(5)), many = mixed(settings_of(140));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(few.hashes[i], many.hashes[i]);
  EXPECT_GT(many.batches.size(), 1U) << "all of them in memory at once";
}

TEST(GenerateMix, ReplacesDuplicates) {
  std::vector<std::string> first, again;
  const auto progress = make_silent_progress();
  bool rejected = false;
  generate_mix({sample_mix()[0]}, settings_of(3), *progress,
               [&](std::vector<GeneratedScenario>& batch) {
                 for (const GeneratedScenario& one : batch)
                   (rejected ? again : first).push_back(one.scenario.hash() + one.scenario.name());
                 const bool reject = !rejected;
                 rejected = true;
                 return reject ? std::vector<std::size_t>{1} : std::vector<std::size_t>();
               });
  ASSERT_EQ(first.size(), 3U);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_NE(again[0], first[1]);
  EXPECT_EQ(again[0].substr(32), "random_0001");
}

/// A sink that takes one in four contents for duplicates.
std::vector<std::size_t> collect(std::vector<GeneratedScenario>& part,
                                 std::vector<std::string>& kept) {
  std::vector<std::size_t> duplicates;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const std::string hash = part[i].scenario.hash();
    if (hash[0] < '4') {
      duplicates.push_back(i);
    } else {
      kept.push_back(hash + part[i].scenario.name());
    }
  }
  return duplicates;
}

TEST(GenerateMix, AMixThatIsInterruptedAfterEachPartContinuesAsIfItWereNot) {
  const auto progress = make_silent_progress();
  std::vector<std::string> complete, interrupted;
  generate_mix(sample_mix(), settings_of(140, 2), *progress,
               [&](std::vector<GeneratedScenario>& part) { return collect(part, complete); });
  MixState state;
  std::size_t parts = 0;
  for (; state.done() < 140; ++parts) {
    double now = 0;  // each look at the clock takes 1/8 s, so that parts have about 8 scenarios
    MixStream stream(sample_mix(), settings_of(140), state, [&] { return now += 0.125; });
    std::vector<GeneratedScenario> part = stream.next(*progress);
    ASSERT_LE(part.size(), 8U);
    stream.next(*progress);  // what was not settled is lost
    MixStream again(sample_mix(), settings_of(140), state, [&] { return now += 0.125; });
    part = again.next(*progress);
    again.commit_part(collect(part, interrupted));
    state = again.state();
  }
  EXPECT_GT(parts, 14U);
  EXPECT_EQ(complete.size(), 140U);
  EXPECT_EQ(interrupted, complete);
}

TEST(GenerateMix, APartHasAtLeastOneScenarioHoweverLongItTakes) {
  double now = 0;
  MixStream stream(sample_mix(), settings_of(3), {}, [&] { return now += 100; });
  const auto progress = make_silent_progress();
  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(stream.next(*progress).size(), 1U);
    stream.commit_part({});
    EXPECT_EQ(stream.state().done(), i);
  }
  EXPECT_TRUE(stream.finished());
}

TEST(GenerateMix, TheStateOfAnotherMixIsRefused) {
  MixState state;
  state.begun = 1;
  state.round = {{3, 0, 0}};  // a fourth generator
  EXPECT_THROW(MixStream(sample_mix(), settings_of(3), state), std::invalid_argument);
  state.round.clear();
  state.begun = 4;
  EXPECT_THROW(MixStream(sample_mix(), settings_of(3), state), std::invalid_argument);
}

TEST(GenerateMix, CertifiesCandidatesInTheRequestedRepresentation) {
  for (const auto representation : {Representation::Grid, Representation::Points}) {
    MixSettings settings = settings_of(2);
    settings.representation = representation;
    settings.conversion_resolution = 0.1;
    settings.describe = [&](const World& world) {
      EXPECT_EQ(world.scenario().representation(), representation);
      return std::vector<KeyedValue>{{{"x"}, Value::of(world.occupancy().resolution())}};
    };
    const auto progress = make_silent_progress();
    generate_mix(sample_mix(), settings, *progress, [&](std::vector<GeneratedScenario>& batch) {
      for (const GeneratedScenario& one : batch) {
        EXPECT_EQ(one.scenario.representation(), representation);
        // A grid keeps its own cells, in single precision; points are rasterized to cells of the
        // model.
        EXPECT_NEAR(one.values.at(0).value.number(),
                    representation == Representation::Grid ? 0.1 : 0.05, 1e-6);
      }
      return std::vector<std::size_t>();
    });
  }
}

TEST(GenerateMix, ReportsTheFirstUnsolvableScenarioForAnyNumberOfThreads) {
  for (const int jobs : {1, 4}) {
    MixSettings settings = settings_of(20, jobs);
    settings.each.robot_radius = 4;
    settings.each.attempts_per_scenario = 2;
    try {
      mixed(settings);
      FAIL();
    } catch (const Error& e) {
      EXPECT_EQ(std::string(e.what()).find("random_0000: no solvable scenario"), 0U) << e.what();
    }
  }
}

TEST(WeightedRoundRobin, FollowsTheWeights) {
  WeightedRoundRobin schedule({1, 3});
  std::vector<int> counts(2, 0);
  for (int i = 1; i <= 400; ++i) {
    const WeightedRoundRobin::Slot slot = schedule.next();
    EXPECT_EQ(slot.index, counts[slot.generator]++);
    EXPECT_NEAR(counts[0], i / 4.0, 1) << i;
  }
  EXPECT_EQ(counts, (std::vector<int>{100, 300}));
}

}  // namespace
}  // namespace slalom
