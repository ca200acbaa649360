#include "family_samples.h"

#include <slalom/generation/generate_mix.h>

namespace slalom {
namespace {

struct Mixed {
  std::vector<std::string> names, hashes, generators;
  std::vector<std::size_t> parts;
};

std::vector<GeneratorShare> sample_mix() {
  return {{family("random"), 2, 7, "random"},
          {family("poisson_forest"), 1, 8, "poisson_forest"},
          {family("traps"), 1, 9, "traps"}};
}

Mixed mixed(const MixTask& task, const std::vector<GeneratorShare>& mix = sample_mix()) {
  Mixed result;
  const auto progress = make_silent_progress();
  generate_mix(mix, task, *progress, [&](std::vector<GeneratedScenario>& part) {
    result.parts.push_back(part.size());
    for (const GeneratedScenario& one : part) {
      result.names.push_back(one.scenario.name());
      result.hashes.push_back(one.scenario.hash());
      result.generators.push_back(one.generator);
    }
    return std::vector<std::size_t>();
  });
  return result;
}

MixTask task_of(int count, int jobs = 1) {
  MixTask task;
  task.each.count = count;
  task.jobs = jobs;
  return task;
}

TEST(GenerateMix, ThreadsDoNotChangeAnything) {
  const Mixed serial = mixed(task_of(150));
  for (const int jobs : {2, 5}) {
    const Mixed parallel = mixed(task_of(150, jobs));
    EXPECT_EQ(parallel.names, serial.names);
    EXPECT_EQ(parallel.hashes, serial.hashes);
  }
}

TEST(GenerateMix, FamiliesHaveTheirShares) {
  const Mixed eight = mixed(task_of(8));
  const std::vector<std::string>& g = eight.generators;
  EXPECT_EQ(std::count(g.begin(), g.end(), "random"), 4);
  EXPECT_EQ(std::count(g.begin(), g.end(), "poisson_forest"), 2);
  EXPECT_EQ(std::count(g.begin(), g.end(), "traps"), 2);
  EXPECT_EQ(eight.names[0], "random_0000");
}

TEST(GenerateMix, AScenarioOfAFamilyDoesNotDependOnTheOthers) {
  const Mixed all = mixed(task_of(8));
  const Mixed alone = mixed(task_of(2), {sample_mix()[2]});
  std::vector<std::string> traps;
  for (std::size_t i = 0; i < 8; ++i)
    if (all.generators[i] == "traps") traps.push_back(all.hashes[i]);
  EXPECT_EQ(traps, alone.hashes);
}

TEST(GenerateMix, MoreIsTheSameAndMore) {
  const Mixed few = mixed(task_of(5)), many = mixed(task_of(140));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(few.hashes[i], many.hashes[i]);
  EXPECT_GT(many.parts.size(), 1U) << "all of them in memory at once";
}

TEST(GenerateMix, WhatWasThereBeforeIsDrawnAnew) {
  std::vector<std::string> first, again;
  const auto progress = make_silent_progress();
  bool refused = false;
  generate_mix({sample_mix()[0]}, task_of(3), *progress, [&](std::vector<GeneratedScenario>& part) {
    for (const GeneratedScenario& one : part)
      (refused ? again : first).push_back(one.scenario.hash() + one.scenario.name());
    const bool refuse = !refused;
    refused = true;
    return refuse ? std::vector<std::size_t>{1} : std::vector<std::size_t>();
  });
  ASSERT_EQ(first.size(), 3U);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_NE(again[0], first[1]);
  EXPECT_EQ(again[0].substr(32), "random_0001");
}

TEST(GenerateMix, CandidatesAreCertifiedInTheRepresentationAskedFor) {
  for (const auto representation : {Representation::Grid, Representation::Points}) {
    MixTask task = task_of(2);
    task.representation = representation;
    task.conversion_resolution = 0.1;
    task.describe = [&](const World& world) {
      EXPECT_EQ(world.scenario().representation(), representation);
      return std::vector<GeneratedValue>{{"x", 1, "", Value::of(world.occupancy().resolution())}};
    };
    const auto progress = make_silent_progress();
    generate_mix(sample_mix(), task, *progress, [&](std::vector<GeneratedScenario>& part) {
      for (const GeneratedScenario& one : part) {
        EXPECT_EQ(one.scenario.representation(), representation);
        // A grid keeps its own cells, in single precision; points are put into cells of the model.
        EXPECT_NEAR(one.values.at(0).value.number(),
                    representation == Representation::Grid ? 0.1 : 0.05, 1e-6);
      }
      return std::vector<std::size_t>();
    });
  }
}

TEST(GenerateMix, TheFirstImpossibleScenarioIsTheErrorWhateverTheThreads) {
  for (const int jobs : {1, 4}) {
    MixTask task = task_of(20, jobs);
    task.each.robot_radius = 4;
    task.each.attempts_per_scenario = 2;
    try {
      mixed(task);
      FAIL();
    } catch (const Error& e) {
      EXPECT_EQ(std::string(e.what()).find("random_0000: no solvable scenario"), 0U) << e.what();
    }
  }
}

TEST(ShareSchedule, FollowsTheWeights) {
  ShareSchedule schedule({1, 3});
  std::vector<int> turns(2, 0);
  for (int i = 1; i <= 400; ++i) {
    const ShareSchedule::Turn turn = schedule.next();
    EXPECT_EQ(turn.index, turns[turn.family]++);
    EXPECT_NEAR(turns[0], i / 4.0, 1) << i;
  }
  EXPECT_EQ(turns, (std::vector<int>{100, 300}));
}

}  // namespace
}  // namespace slalom
