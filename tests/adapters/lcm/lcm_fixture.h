#pragma once

#include "private_network.h"

#include <slalom/lcm/lcm_method.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>
#include <lcm/lcm-cpp.hpp>

#include <memory>
#include <string>

namespace slalom {

/// Tests in a network of their own, where permitted.
class LcmTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    static const bool entered = enter_private_network();
    lcm::LCM probe(LcmOptions().url);
    usable_ = probe.good() && probe.subscribeFunction("PROBE", hear, &probe) != nullptr;
    EXPECT_TRUE(usable_ || !entered) << "LCM does not work in a private network";
  }
  void SetUp() override {
    if (!usable_) GTEST_SKIP() << "neither a private network nor one with multicast";
  }

  static std::unique_ptr<Method> make(const std::string& keys) {
    const IniFile ini =
        IniFile::from_text("[method.a]\nadapter = lcm\n" + keys, "/somewhere/campaign.ini");
    return make_lcm_method({ini, "method.a", RobotModel(), SensorModel()});
  }

  /// An external process with that fault, and at most 1 s for an answer.
  static std::unique_ptr<Method> make_faulty(const std::string& fault,
                                             const std::string& keys = "deadline = 1\n") {
    return make("launch = exec " FAULTY_PROCESS " " + fault + "\n" + keys);
  }

  /// 1 m ahead in an empty room.
  static const World& room() {
    static const World world(
        Scenario::continuous("room", {0, 0, 5, 5}, Primitives(), {1, 2.5, 0}, {2, 2.5}), 0.05);
    return world;
  }

  static SimulationResult drive(Method& method, std::uint64_t method_seed);

 private:
  static void hear(const lcm::ReceiveBuffer*, const std::string&, lcm::LCM*) {}
  inline static bool usable_ = false;
};

/// Gives runs the seed that a test asks for instead of the simulator's.
class SeededMethod : public Method {
 public:
  SeededMethod(Method& method, std::uint64_t seed) : method_(method), seed_(seed) {}
  void reset(const Task& task) override {
    Task seeded = task;
    seeded.seed = seed_;
    method_.reset(seeded);
  }
  Command step(const Observation& observation) override { return method_.step(observation); }
  void finish(const std::string& outcome) override { method_.finish(outcome); }

 private:
  Method& method_;
  std::uint64_t seed_;
};

inline SimulationResult LcmTest::drive(Method& method, std::uint64_t method_seed) {
  SeededMethod seeded(method, method_seed);
  return simulate(room(), {}, 1, seeded);
}

}  // namespace slalom
