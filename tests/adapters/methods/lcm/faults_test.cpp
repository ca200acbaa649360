// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "lcm_fixture.h"

namespace slalom {
namespace {

constexpr std::uint64_t kGood = 1, kFaulty = 13;
constexpr double kFaultyTime = 0.3;  // s, time of the fourth observation

/// A run in which the fault occurs, followed by one with the same method.
class Faults : public LcmTest {
 protected:
  /// The run ends with `outcome` after three cycles at 0.5 m/s; the next run is not affected.
  static std::string expect_end(const std::string& fault, Outcome outcome) {
    const auto method = make_faulty(fault);
    return expect_end(fault, outcome, *method, *method);
  }

  /// The same for a missed deadline: the time for the fourth reply elapses at once.
  static std::string expect_missed_deadline(const std::string& fault) {
    HurryingClock clock;
    const auto method = make_faulty(fault, kLongDeadlines, clock);
    HookedMethod hurried = hurry_from(*method, clock, kFaultyTime);
    return expect_end(fault, Outcome::MethodDeadline, hurried, *method);
  }

  static std::string expect_end(const std::string& fault, Outcome outcome, Method& faulty,
                                Method& method) {
    const SimulationResult result = run(faulty, kFaulty);
    EXPECT_EQ(to_string(result.outcome), to_string(outcome)) << result.detail;
    EXPECT_NEAR(result.trajectory.duration(), fault == "ends_at_start" ? 0 : 0.3, 1e-9);
    expect_normal_run(method, kGood);
    return result.detail.substr(0, result.detail.find(", at"));
  }

  static void expect_normal_run(Method& method, std::uint64_t seed) {
    const SimulationResult result = run(method, seed);
    EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
    for (const Sample& sample : result.trajectory.samples) EXPECT_EQ(sample.command_v, 0.5);
  }

  static void expect_ignored(const std::string& fault) {
    const auto method = make_faulty(fault);
    expect_normal_run(*method, kFaulty);
  }
};

/// Not at the deadline, which is an hour, so that the test would time out.
TEST_F(Faults, AProcessThatIsKilledEndsTheRunAtOnce) {
  const auto method = make_faulty("killed", "deadline = 3600\n");
  EXPECT_TRUE(mentions(expect_end("killed", Outcome::MethodError, *method, *method),
                       {"external process ended", "signal 9 (Killed)"}));
}

TEST_F(Faults, AProcessThatExitsEndsTheRunWithItsStatus) {
  EXPECT_TRUE(mentions(expect_end("exits", Outcome::MethodError),
                       {"external process ended", "exit status 5"}));
  EXPECT_TRUE(mentions(expect_end("ends_at_start", Outcome::MethodError),
                       {"external process ended", "exit status 4"}));
}

TEST_F(Faults, AMissingReplyIsAMissedDeadline) {
  for (const std::string fault : {"hung", "silent", "wrong_sequence", "wrong_run", "slow"})
    EXPECT_TRUE(mentions(expect_missed_deadline(fault),
                         {"no answer", "external process", "observation", "100 s"}))
        << fault;
  EXPECT_TRUE(
      mentions(expect_missed_deadline("garbled_before"),
               {"no answer", "external process", "observation", "100 s", "cannot be decoded: 4"}));
}

TEST_F(Faults, AnErrorOfTheMethodIsReported) {
  EXPECT_TRUE(mentions(expect_end("error", Outcome::MethodError),
                       {"external process reported", "unsupported robot"}));
}

TEST_F(Faults, ANanCommandIsInvalid) {
  expect_end("nan", Outcome::MethodInvalidCommand);
}

TEST_F(Faults, MessagesThatAreNoReplyToTheObservationAreIgnored) {
  expect_ignored("garbled");
  expect_ignored("flooded");
  expect_ignored("repeated");
  expect_ignored("chatty");
}

TEST_F(Faults, TwoDifferentCommandsForOneObservationEndTheRun) {
  for (const char* fault : {"duplicate", "late"}) {
    const auto method = make_faulty(fault);
    const SimulationResult result = run(*method, kFaulty);
    EXPECT_EQ(to_string(result.outcome), to_string(Outcome::MethodError)) << fault;
    EXPECT_TRUE(mentions(result.detail, {"two different commands for one observation"})) << fault;
    expect_normal_run(*method, kGood);
  }
}

/// Errors that are reported before the first run of a campaign.
TEST_F(Faults, AProcessThatCannotBeUsedIsRefused) {
  const std::string where = "/somewhere/campaign.ini:3: [method.a] launch: ";
  const auto refuses = [&where](const std::string& fault,
                                std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, where, words, [&] {
      make_faulty(fault, fault == "silent_at_hello" ? "startup_time = 0.3\n" : kLongDeadlines);
    });
  };
  EXPECT_TRUE(refuses("refuses", {"external process reported", "unsupported robot"}));
  EXPECT_TRUE(refuses("ends_at_hello", {"external process ended", "exit status 3"}));
  EXPECT_TRUE(refuses("other_version", {"protocol version 8", "expected version 1"}));
  EXPECT_TRUE(refuses("silent_at_hello", {"no answer", "external process", "hello", "0.3 s"}));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, where, {"external process ended", "exit status 127"},
                           [] { make("launch = no_such_program_here\n"); }));
}

TEST_F(Faults, WithoutAProcessEachRunMissesItsDeadline) {
  const auto method = make("startup_time = 0.2\n");
  for (int i = 0; i < 2; ++i) {
    const SimulationResult result = run(*method, kGood);
    EXPECT_EQ(result.outcome, Outcome::MethodDeadline);
    EXPECT_TRUE(mentions(result.detail, {"no answer", "external process", "hello", "0.2 s"}));
  }
}

}  // namespace
}  // namespace slalom
