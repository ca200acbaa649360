#include "error_text.h"
#include "lcm_fixture.h"

#include <chrono>

namespace slalom {
namespace {

constexpr std::uint64_t kGood = 1, kFaulty = 13;

/// A run in which the fault shows, and one after it with the same method.
class Faults : public LcmTest {
 protected:
  /// The run ends like this, after three cycles at 0.5 m/s; the next run is as if nothing had been.
  static std::string expect_end(const std::string& fault, Outcome outcome) {
    const auto method = make_faulty(fault);
    const SimulationResult result = drive(*method, kFaulty);
    EXPECT_EQ(to_string(result.outcome), to_string(outcome)) << result.detail;
    EXPECT_NEAR(result.trajectory.duration(), fault == "ends_at_start" ? 0 : 0.3, 1e-9);
    expect_untouched(*method, kGood);
    return result.detail.substr(0, result.detail.find(", at"));
  }

  static void expect_untouched(Method& method, std::uint64_t seed) {
    const SimulationResult result = drive(method, seed);
    EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
    for (const Sample& sample : result.trajectory.samples) EXPECT_EQ(sample.command_v, 0.5);
  }

  static void expect_ignored(const std::string& fault) {
    const auto method = make_faulty(fault);
    expect_untouched(*method, kFaulty);
  }
};

TEST_F(Faults, AProcessThatIsKilledEndsTheRunAtOnce) {
  const auto before = std::chrono::steady_clock::now();
  EXPECT_EQ(expect_end("killed", Outcome::MethodError),
            "the external process ended (signal 9 (Killed))");
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - before;
  EXPECT_LT(taken.count(), 5);
}

TEST_F(Faults, AProcessThatExitsEndsTheRunWithItsStatus) {
  EXPECT_EQ(expect_end("exits", Outcome::MethodError),
            "the external process ended (exit status 5)");
  EXPECT_EQ(expect_end("ends_at_start", Outcome::MethodError),
            "the external process ended (exit status 4)");
}

TEST_F(Faults, SilenceIsAMissedDeadline) {
  const std::string text =
      "no answer of the external process to the observation within 1 s of wall-clock time";
  for (const std::string fault : {"hung", "silent", "wrong_sequence", "wrong_run", "slow"})
    EXPECT_EQ(expect_end(fault, Outcome::MethodDeadline), text) << fault;
  EXPECT_EQ(expect_end("garbled_only", Outcome::MethodDeadline),
            text + "; messages that cannot be decoded: 4");
}

TEST_F(Faults, AnErrorOfTheMethodIsPassedOn) {
  EXPECT_EQ(expect_end("error", Outcome::MethodError),
            "the external process says: I do not like it here");
}

TEST_F(Faults, ACommandThatIsNoNumberIsInvalid) {
  expect_end("nan", Outcome::MethodInvalidCommand);
}

TEST_F(Faults, WhatDoesNotAnswerTheObservationIsIgnored) {
  expect_ignored("garbled");
  expect_ignored("duplicate");
  expect_ignored("late");
  expect_ignored("chatty");
}

/// What a campaign is told before its first run.
TEST_F(Faults, AProcessThatCannotBeUsedIsRefused) {
  const std::string where = "/somewhere/campaign.ini:3: [method.a] launch: ";
  const auto refusal = [](const std::string& fault) {
    return error_text(Culprit::Usage, [&] {
      make_faulty(fault, fault == "silent_at_hello" ? "startup_time = 0.3\n" : "");
    });
  };
  EXPECT_EQ(refusal("refuses"), where + "the external process says: I do not like it here");
  EXPECT_EQ(refusal("ends_at_hello"), where + "the external process ended (exit status 3)");
  EXPECT_EQ(refusal("other_version"),
            where + "the external process speaks version 8 of the protocol; expected version 1");
  EXPECT_EQ(refusal("silent_at_hello"),
            where +
                "no answer of the external process to the hello within 0.3 s of wall-clock "
                "time");
  EXPECT_EQ(error_text(Culprit::Usage, [] { make("launch = no_such_program_here\n"); }),
            where + "the external process ended (exit status 127)");
}

TEST_F(Faults, NobodyThereIsAMissedDeadlineOfEachRun) {
  const auto method = make("startup_time = 0.2\n");
  for (int run = 0; run < 2; ++run) {
    const SimulationResult result = drive(*method, kGood);
    EXPECT_EQ(result.outcome, Outcome::MethodDeadline);
    EXPECT_EQ(result.detail.rfind("no answer of the external process to the hello within 0.2 s", 0),
              0U)
        << result.detail;
  }
}

}  // namespace
}  // namespace slalom
