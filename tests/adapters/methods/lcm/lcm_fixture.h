// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hurrying_clock.h"
#include "places.h"
#include "private_network.h"

#include <slalom/lcm/lcm_method.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>
#include <lcm/lcm-cpp.hpp>

#include <functional>
#include <memory>
#include <string>

namespace slalom {

inline const std::string kFaultyProcess = kPrograms + "/lcm_faulty_process";

/// Tests in a private network, where permitted.
class LcmTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    static const bool entered = enter_private_network();
    lcm::LCM probe(kLcmUrl);
    usable_ = probe.good() && probe.subscribeFunction("PROBE", ignore, &probe) != nullptr;
    EXPECT_TRUE(usable_ || !entered) << "LCM does not work in a private network";
  }
  void SetUp() override {
    if (!usable_) GTEST_SKIP() << "neither a private network nor one with multicast";
  }

  static std::unique_ptr<Method> make(const std::string& keys,
                                      const WallClock& clock = steady_seconds) {
    const IniFile ini =
        IniFile::from_text("[method.a]\nadapter = lcm\n" + keys, "/somewhere/campaign.ini");
    return read_lcm_method(ini, "method.a", clock)(RobotModel(), SensorModel());
  }

  /// Not missed on a slow machine, only with a HurryingClock.
  static constexpr char kLongDeadlines[] = "deadline = 100\nstartup_time = 100\n";

  /// Launches an external process with this fault.
  static std::unique_ptr<Method> make_faulty(const std::string& fault,
                                             const std::string& keys = kLongDeadlines,
                                             const WallClock& clock = steady_seconds) {
    return make("launch = exec " + kFaultyProcess + " " + fault + "\n" + keys, clock);
  }

  /// 1 m ahead in an empty room.
  static const World& room() {
    static const World world(
        Scenario::continuous("room", {0, 0, 5, 5}, Primitives(), {1, 2.5, 0}, {2, 2.5}), 0.05);
    return world;
  }

  /// For runs in real time: 0.5 m ahead.
  static const World& short_room() {
    static const World world(room().scenario().with_start_goal({1, 2.5, 0}, {1.5, 2.5}), 0.05);
    return world;
  }

  static SimulationResult run(Method& method, std::uint64_t seed, const World& world = room());

 private:
  static void ignore(const lcm::ReceiveBuffer*, const std::string&, lcm::LCM*) {}
  inline static bool usable_ = false;
};

/// Replaces the simulator's seed by the seed given in the test.
class SeededMethod : public Method {
 public:
  SeededMethod(Method& method, std::uint64_t seed) : method_(method), seed_(seed) {}
  void reset(const NavigationTask& task) override {
    NavigationTask seeded = task;
    seeded.seed = seed_;
    method_.reset(seeded);
  }
  Command step(const Observation& observation) override { return method_.step(observation); }
  void finish(const std::string& outcome) override { method_.finish(outcome); }

 private:
  Method& method_;
  std::uint64_t seed_;
};

inline SimulationResult LcmTest::run(Method& method, std::uint64_t seed, const World& world) {
  SeededMethod seeded(method, seed);
  return simulate(world, {}, 1, seeded);
}

}  // namespace slalom
