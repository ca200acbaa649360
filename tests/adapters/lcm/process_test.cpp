#include "lcm_fixture.h"

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace slalom {
namespace {

bool soon(const std::function<bool()>& holds) {
  for (int i = 0; i < 3000 && !holds(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return holds();
}

/// The life of the process that a method launches. It writes its number into a file first.
class Process : public LcmTest {
 protected:
  void TearDown() override { std::remove(file_.c_str()); }

  std::unique_ptr<Method> launch(const std::string& fault, const std::string& keys = "") const {
    return make("launch = echo $$ >" + file_ + "; exec " FAULTY_PROCESS " " + fault + "\n" + keys);
  }
  pid_t number() const {
    pid_t pid = 0;
    std::ifstream(file_) >> pid;
    return pid;
  }
  static bool runs(pid_t pid) { return kill(pid, 0) == 0; }
  /// Whether it is no more, or only a zombie that somebody has to reap.
  static bool is_dead(pid_t pid) {
    std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
    std::string number, name, state;
    stat >> number >> name >> state;
    return state.empty() || state == "Z";
  }

  /// A child that was killed and that can be reaped. It shows as a zombie a little sooner: while
  /// its threads still end.
  static bool can_be_reaped(pid_t pid) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == pid;
  }

  std::string file_ = testing::TempDir() + "slalom_lcm_process_" + std::to_string(getpid());
};

TEST_F(Process, EndsWithItsMethod) {
  auto method = launch("none");
  const pid_t pid = number();
  ASSERT_GT(pid, 0);
  EXPECT_TRUE(runs(pid));
  EXPECT_EQ(getpgid(pid), pid);
  method.reset();
  EXPECT_FALSE(runs(pid));
}

TEST_F(Process, IsTheSameForAllRunsThatGoWell) {
  const auto method = launch("none");
  const pid_t pid = number();
  for (int run = 0; run < 3; ++run) EXPECT_EQ(drive(*method, 1).outcome, Outcome::Success);
  EXPECT_EQ(number(), pid);
}

TEST_F(Process, ThatHangsIsKilledAndReplaced) {
  const auto method = launch("hung", "deadline = 2\n");
  const pid_t first = number();
  EXPECT_EQ(drive(*method, 13).outcome, Outcome::MethodDeadline);
  EXPECT_FALSE(runs(first));
  EXPECT_EQ(drive(*method, 1).outcome, Outcome::Success);
  EXPECT_NE(number(), first);
}

TEST_F(Process, IsReplacedWhenItWasKilledBetweenRuns) {
  const auto method = launch("none");
  EXPECT_EQ(drive(*method, 1).outcome, Outcome::Success);
  const pid_t pid = number();
  kill(pid, SIGKILL);
  ASSERT_TRUE(soon([pid] { return can_be_reaped(pid); }));
  EXPECT_EQ(drive(*method, 1).outcome, Outcome::Success);
}

TEST_F(Process, MayLiveLongerThanARunMayTake) {
  rlimit before{};
  getrlimit(RLIMIT_CPU, &before);
  const rlimit for_one_run{3600, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_CPU, &for_one_run), 0);
  const auto method = make("launch = ulimit -t >" + file_ + "; exec " FAULTY_PROCESS " none\n");
  setrlimit(RLIMIT_CPU, &before);
  std::string limit;
  std::ifstream(file_) >> limit;
  EXPECT_EQ(limit,
            before.rlim_max == RLIM_INFINITY ? "unlimited" : std::to_string(before.rlim_max));
}

TEST_F(Process, DiesWithAWorkerThatIsKilled) {
  const pid_t worker = fork();
  if (worker == 0) {
    const auto method = launch("none");
    while (true) pause();
  }
  ASSERT_TRUE(soon([this] { return number() > 0; }));
  const pid_t pid = number();
  EXPECT_TRUE(runs(pid));
  kill(worker, SIGKILL);
  waitpid(worker, nullptr, 0);
  EXPECT_TRUE(soon([pid] { return is_dead(pid); }));
}

/// The answer to observation k comes within its period and is in force from k + 1 on.
TEST_F(Process, InRealTimeTheNewestCommandCountsAndTimeIsTheWallClocks) {
  const auto method = launch("silent", "mode = realtime\ndeadline = 1\n");
  const auto before = std::chrono::steady_clock::now();
  const SimulationResult result = drive(*method, 1);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - before;
  ASSERT_EQ(result.outcome, Outcome::Success) << result.detail;
  const auto& samples = result.trajectory.samples;
  EXPECT_EQ(samples.front().command_v, 0);
  for (std::size_t i = 5; i < samples.size(); ++i) EXPECT_EQ(samples[i].command_v, 0.5) << i;
  EXPECT_GT(taken.count(), result.trajectory.duration() - 0.11);
}

TEST_F(Process, InRealTimeALongSilenceIsAMissedDeadline) {
  // It is silent once only, then answers on: the command before is held.
  const auto silent = launch("silent", "mode = realtime\ndeadline = 1\n");
  const SimulationResult held = drive(*silent, 13);
  EXPECT_EQ(held.outcome, Outcome::Success) << held.detail;
  const auto hung = launch("hung", "mode = realtime\ndeadline = 1\n");
  const SimulationResult result = drive(*hung, 13);
  EXPECT_EQ(result.outcome, Outcome::MethodDeadline);
  EXPECT_EQ(result.trajectory.samples.back().command_v, 0.5);
  EXPECT_EQ(drive(*hung, 1).outcome, Outcome::Success);
}

}  // namespace
}  // namespace slalom
