// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "lcm_fixture.h"
#include "places.h"
#include "wait_until.h"

#include <csignal>
#include <fstream>
#include <netinet/in.h>
#include <set>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

/// The lifetime of the process that a method launches. It first writes its process id to a file.
class Process : public LcmTest {
 protected:
  void TearDown() override { std::remove(file_.c_str()); }

  std::unique_ptr<Method> launch(const std::string& fault, const std::string& keys = kLongDeadlines,
                                 const WallClock& clock = steady_seconds) const {
    return make(
        "launch = echo $$ >" + file_ + "; exec " + kFaultyProcess + " " + fault + "\n" + keys,
        clock);
  }
  pid_t process_id() const {
    pid_t pid = 0;
    std::ifstream(file_) >> pid;
    return pid;
  }
  /// The URL that a process was given which then succeeded.
  std::string url_of_a_run(const std::string& keys = "") const {
    const std::string line =
        "launch = echo $SLALOM_LCM_URL >" + file_ + "; exec " + kFaultyProcess + " none\n";
    EXPECT_EQ(run(*make(line + kLongDeadlines + keys), 1).outcome, Outcome::Success);
    std::string url;
    std::ifstream(file_) >> url;
    return url;
  }
  static bool is_running(pid_t pid) { return kill(pid, 0) == 0; }
  /// Whether the process does not exist or is a zombie.
  static bool is_dead(pid_t pid) {
    std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
    std::string number, name, state;
    stat >> number >> name >> state;
    return state.empty() || state == "Z";
  }

  /// Whether a child has ended and can be reaped. It becomes a zombie slightly earlier, while its
  /// threads are still ending.
  static bool can_be_reaped(pid_t pid) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == pid;
  }

  std::string file_ = testing::TempDir() + "slalom_lcm_process_" + std::to_string(getpid());
};

TEST_F(Process, EndsWithItsMethod) {
  auto method = launch("none");
  const pid_t pid = process_id();
  ASSERT_GT(pid, 0);
  EXPECT_TRUE(is_running(pid));
  EXPECT_EQ(getpgid(pid), pid);
  method.reset();
  EXPECT_FALSE(is_running(pid));
}

TEST_F(Process, IsReusedAfterSuccessfulRuns) {
  const auto method = launch("none");
  const pid_t pid = process_id();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(run(*method, 1).outcome, Outcome::Success);
  EXPECT_EQ(process_id(), pid);
}

TEST_F(Process, IsKilledAndReplacedWhenItHangs) {
  HurryingClock clock;
  const auto method = launch("hung", kLongDeadlines, clock);
  const pid_t first = process_id();
  HookedMethod hurried = hurry_from(*method, clock, 0.3);
  EXPECT_EQ(run(hurried, 13).outcome, Outcome::MethodDeadline);
  EXPECT_FALSE(is_running(first));
  EXPECT_EQ(run(*method, 1).outcome, Outcome::Success);
  EXPECT_NE(process_id(), first);
}

TEST_F(Process, IsReplacedWhenItWasKilledBetweenRuns) {
  const auto method = launch("none");
  EXPECT_EQ(run(*method, 1).outcome, Outcome::Success);
  const pid_t pid = process_id();
  kill(pid, SIGKILL);
  wait_until([pid] { return can_be_reaped(pid); });
  EXPECT_EQ(run(*method, 1).outcome, Outcome::Success);
}

TEST_F(Process, IsNotSubjectToTheCpuTimeLimitOfARun) {
  rlimit before{};
  getrlimit(RLIMIT_CPU, &before);
  const rlimit for_one_run{3600, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_CPU, &for_one_run), 0);
  const auto method = make("launch = ulimit -t >" + file_ + "; exec " + kFaultyProcess + " none\n");
  setrlimit(RLIMIT_CPU, &before);
  std::string limit;
  std::ifstream(file_) >> limit;
  EXPECT_EQ(limit,
            before.rlim_max == RLIM_INFINITY ? "unlimited" : std::to_string(before.rlim_max));
}

TEST_F(Process, IsKilledWithItsWorker) {
  const pid_t worker = fork();
  if (worker == 0) {
    const auto method = launch("none");
    while (true) pause();
  }
  wait_until([this] { return process_id() > 0; });
  const pid_t pid = process_id();
  EXPECT_TRUE(is_running(pid));
  kill(worker, SIGKILL);
  waitpid(worker, nullptr, 0);
  wait_until([pid] { return is_dead(pid); });
}

/// Each shares its buffer (on Linux 212,992 bytes, ten milliseconds of a conversation) with nobody.
TEST_F(Process, HasAPortOfItsOwnUnlessAUrlIsGiven) {
  const auto urls_of_three = [this](const std::string& keys) {
    std::set<std::string> urls;
    for (int i = 0; i < 3; ++i) urls.insert(url_of_a_run(keys));
    return urls;
  };
  const std::set<std::string> own = urls_of_three("");
  EXPECT_EQ(own.size(), 3U);
  EXPECT_EQ(own.count(kLcmUrl), 0U);
  EXPECT_EQ(urls_of_three(std::string("url = ") + kLcmUrl + "\n"), std::set<std::string>{kLcmUrl});
}

/// A socket that shares its port with nobody.
class TakenPort {
 public:
  explicit TakenPort(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;
  ~TakenPort() { close(socket_); }

 private:
  int socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

TEST_F(Process, HasAnotherPortIfItsOwnIsInUse) {
  const std::string url = url_of_a_run();
  const int next = std::stoi(url.substr(url.rfind(':') + 1)) + 1;
  const TakenPort taken(next);
  EXPECT_EQ(url_of_a_run().find(":" + std::to_string(next) + "?"), std::string::npos);
}

TEST_F(Process, IsRefusedIfThePortOfItsUrlIsInUse) {
  const TakenPort taken(8999);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "/somewhere/campaign.ini:4: [method.a] url: ",
                           {"LCM cannot be used with 'udpm://239.255.76.67:8999?ttl=0'"}, [] {
                             make("launch = exec true\nurl = udpm://239.255.76.67:8999?ttl=0\n");
                           }));
}

void count_messages(const lcm::ReceiveBuffer*, const std::string&, int* count) {
  ++*count;
}

/// The reply to observation k arrives within its period and is applied from cycle k + 1 on.
TEST_F(Process, InRealTimeTheLatestCommandIsAppliedOnTheWallClock) {
  // From the third cycle on the clock is not read until the process has replied.
  lcm::LCM listener(kLcmUrl);
  int cycles = 0, replies = 0;
  listener.subscribeFunction(".*_COMMAND", count_messages, &replies);
  const auto method = launch(
      "silent", std::string(kLongDeadlines) + "mode = realtime\nurl = " + kLcmUrl + "\n", [&] {
        while (cycles > 2 && replies == 0) listener.handle();
        return steady_seconds();
      });
  HookedMethod counted(
      *method, [&](const Observation&) { ++cycles; }, [] {});
  const double before = steady_seconds();
  const SimulationResult result = run(counted, 1, short_room());
  const double elapsed = steady_seconds() - before;
  ASSERT_EQ(result.outcome, Outcome::Success) << result.detail;
  const auto& samples = result.trajectory.samples;
  EXPECT_EQ(samples.front().command_v, 0);
  for (std::size_t i = 5; i < samples.size(); ++i) EXPECT_EQ(samples[i].command_v, 0.5) << i;
  EXPECT_GT(elapsed, result.trajectory.duration() - 0.11);
}

TEST_F(Process, InRealTimeMissingCommandsAreAMissedDeadline) {
  // Only one reply is missing: the previous command is held.
  const auto silent = launch("silent", std::string(kLongDeadlines) + "mode = realtime\n");
  const SimulationResult held = run(*silent, 13, short_room());
  EXPECT_EQ(held.outcome, Outcome::Success) << held.detail;
  const HurryingClock clock(30);
  const auto hung = launch("hung", std::string(kLongDeadlines) + "mode = realtime\n", clock);
  // The robot moves after the first command; from then on the clock hurries.
  HookedMethod hurried(
      *hung, [&](const Observation& observation) { clock.hurry(observation.v > 0); },
      [&] { clock.hurry(false); });
  const SimulationResult result = run(hurried, 13);
  EXPECT_EQ(result.outcome, Outcome::MethodDeadline);
  EXPECT_EQ(result.trajectory.samples.back().command_v, 0.5);
  EXPECT_EQ(run(*hung, 1, short_room()).outcome, Outcome::Success);
}

}  // namespace
}  // namespace slalom
