// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "lcm_fixture.h"
#include "places.h"
#include "wait_until.h"

#include <slalom/core/wall_clock.h>
#include <slalom/lcm/method_host.h>
#include <slalom/library/library_method.h>

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

constexpr char kSection[] = "method.a";

/// Hosts follow_the_gap with the settings of a hello and one more setting.
MethodHost gap_host(const std::string& key = "look_ahead", const std::string& value = "1.7") {
  return MethodHost("gap", [=](const hello_t& hello) {
    IniFile ini = IniFile::from_text("[method.a]\nadapter = library\nplugin = " + kFollowTheGap);
    for (const auto& [k, v] : settings_of(hello)) ini.set(kSection, k, v);
    ini.set(kSection, key, value);
    return read_library_method(ini, kSection)(robot_of(hello), sensor_of(hello));
  });
}

pid_t start_logger(const std::string& path) {
  const pid_t pid = fork();
  if (pid != 0) return pid;
  const int null_device = open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) dup2(null_device, stream);
  execlp("lcm-logger", "lcm-logger", "--quiet", "--flush-interval=20",
         (std::string("--lcm-url=") + kLcmUrl).c_str(), path.c_str(), nullptr);
  _exit(127);
}

bool is(const lcm::LogEvent& event, const std::string& suffix) {
  return event.channel.size() > suffix.size() &&
         event.channel.substr(event.channel.size() - suffix.size()) == suffix;
}

template <typename Message>
Message decoded(const lcm::LogEvent& event) {
  Message message;
  EXPECT_TRUE(decode_message(event.data, static_cast<std::size_t>(event.datalen), message))
      << event.channel;
  return message;
}

/// A run recorded by lcm-logger, and its log.
class Log : public LcmTest {
 protected:
  void SetUp() override {
    LcmTest::SetUp();
    if (IsSkipped()) return;
    // On a busy machine lcm-logger loses messages.
    for (int attempt = 0; attempt < 10 && !is_complete(); ++attempt) {
      ASSERT_NO_FATAL_FAILURE(record());
    }
    ASSERT_TRUE(is_complete()) << "lcm-logger loses messages in each of 10 runs";
  }
  void TearDown() override { std::filesystem::remove(path_); }

  std::uintmax_t size() const {
    std::error_code absent;
    const std::uintmax_t size = std::filesystem::file_size(path_, absent);
    return absent ? 0 : size;
  }

  std::string path_ = testing::TempDir() + "slalom_lcm_" + std::to_string(getpid()) + ".log";
  SimulationResult run_;

 private:
  void record() {
    std::filesystem::remove(path_);
    logger_ = start_logger(path_);
    lcm::LCM probe(kLcmUrl);
    wait_until([&] {
      probe.publish("PROBE", "x", 1);
      return size() > 0 || waitpid(logger_, nullptr, WNOHANG) != 0;
    });
    ASSERT_GT(size(), 0U) << "lcm-logger does not log";
    run_logged();
  }

  void run_logged() {
    const auto method = make("launch = exec slalom-lcm-method --plugin " + kFollowTheGap +
                             "\nlook_ahead = 1.7\nurl = " + std::string(kLcmUrl) + "\n");
    const World world(room().scenario().with_start_goal({1, 2.5, 0}, {3, 4}), 0.05);
    run_ = simulate(world, {}, 1, *method);
    lcm::LCM probe(kLcmUrl);
    const double until = steady_seconds() + 5;  // the run's end may be lost, too
    wait_until([&] {  // the logger flushes its buffer when another message arrives
      probe.publish("PROBE", "x", 1);
      return count_logged("_RUN_END") > 0 || steady_seconds() > until;
    });
    kill(logger_, SIGINT);
    waitpid(logger_, nullptr, 0);
  }

  /// Each cycle once, its command after its observation: a message that was lost may be sent again.
  bool is_complete() const {
    if (size() == 0) return false;
    std::int64_t observations = 0, commands = 0;
    lcm::LogFile log(path_, "r");
    while (const lcm::LogEvent* event = log.readNextEvent()) {
      if (is(*event, "_OBSERVATION")) {
        if (decoded<observation_t>(*event).sequence != observations++) return false;
      } else if (is(*event, "_COMMAND")) {
        if (decoded<command_t>(*event).sequence != commands++ || commands > observations)
          return false;
      }
    }
    const auto cycles = static_cast<std::int64_t>(run_.cycle_seconds.size());
    return observations == cycles && commands == cycles;
  }

  std::size_t count_logged(const std::string& suffix) const {
    std::size_t count = 0;
    lcm::LogFile log(path_, "r");
    while (const lcm::LogEvent* event = log.readNextEvent()) count += is(*event, suffix) ? 1 : 0;
    return count;
  }

  pid_t logger_ = -1;
};

TEST_F(Log, ContainsAllMessagesOfALockstepRunInOrder) {
  ASSERT_EQ(run_.outcome, Outcome::Success) << run_.detail;
  const auto& samples = run_.trajectory.samples;
  std::size_t observations = 0, commands = 0, ends = 0;
  lcm::LogFile log(path_, "r");
  ASSERT_TRUE(log.good());
  while (const lcm::LogEvent* event = log.readNextEvent()) {
    if (is(*event, "_OBSERVATION")) {
      const auto message = decoded<observation_t>(*event);
      EXPECT_EQ(commands, observations) << "an answer is missing";
      EXPECT_EQ(message.sequence, static_cast<std::int64_t>(observations));
      ASSERT_LT(observations, samples.size());
      EXPECT_EQ(message.time, samples[observations].t);
      EXPECT_EQ(message.ranges.size(), 181U);
      ++observations;
    } else if (is(*event, "_COMMAND")) {
      const auto message = decoded<command_t>(*event);
      EXPECT_EQ(message.sequence, static_cast<std::int64_t>(commands));
      ASSERT_LT(commands, observations);
      EXPECT_EQ(message.v, samples[commands].command_v);
      EXPECT_EQ(message.w, samples[commands].command_w);
      ++commands;
    } else if (is(*event, "_RUN_END")) {
      EXPECT_EQ(decoded<run_end_t>(*event).outcome, "success");
      ++ends;
    }
  }
  EXPECT_EQ(observations, run_.cycle_seconds.size());
  EXPECT_EQ(commands, observations);
  EXPECT_EQ(ends, 1U);
}

TEST_F(Log, ReplayThroughTheSameMethodGivesTheSameCommands) {
  const LogReplay found = replay_log(path_, [] { return gap_host(); });
  EXPECT_EQ(found.runs, 1U);
  EXPECT_EQ(found.observations, run_.cycle_seconds.size());
  EXPECT_EQ(found.commands, run_.cycle_seconds.size());
  EXPECT_EQ(found.different, 0U) << found.first_difference;
}

TEST_F(Log, ReplayThroughAnotherMethodReportsTheFirstDifference) {
  const LogReplay found = replay_log(path_, [] { return gap_host("turn_gain", "1"); });
  EXPECT_GT(found.different, 0U);
  EXPECT_EQ(found.first_difference.rfind("observation ", 0), 0U) << found.first_difference;
  EXPECT_NE(found.first_difference.find(" of run 1: ("), std::string::npos);
}

TEST_F(LcmTest, AnInvalidLogIsRefused) {
  const std::string path = testing::TempDir() + "slalom_no_log_" + std::to_string(getpid());
  const auto refuses = [&](const std::string& what) {
    return throws_error(ErrorKind::File, path + ": ", {what, "expected a log of lcm-logger"},
                        [&] { replay_log(path, [] { return gap_host(); }); });
  };
  EXPECT_TRUE(refuses("cannot be read"));
  std::ofstream(path) << "This is text, and more of it than a header has.\n";
  EXPECT_TRUE(refuses("no observations"));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace slalom
