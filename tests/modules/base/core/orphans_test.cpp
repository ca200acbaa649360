// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/orphans.h>

#include <gtest/gtest.h>

#include <csignal>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace slalom {
namespace {

[[noreturn]] void wait_for_signals() {
  while (true) pause();
}

pid_t waiting_child() {
  const pid_t pid = fork();
  if (pid == 0) wait_for_signals();
  return pid;
}

/// Waits for a child that leaves a process of another session behind. Returns that one.
pid_t orphan() {
  int ends[2];
  if (pipe(ends) != 0) return -1;
  const pid_t child = fork();
  if (child == 0) {
    setsid();
    const pid_t left = waiting_child();
    _exit(write(ends[1], &left, sizeof left) > 0 ? 0 : 1);
  }
  pid_t left = -1;
  if (read(ends[0], &left, sizeof left) <= 0) return -1;
  waitpid(child, nullptr, 0);
  close(ends[0]);
  close(ends[1]);
  return left;
}

bool exists(pid_t process) {
  return kill(process, 0) == 0;
}

/// The exit status of a process of its own, in which the test may become the parent of orphans.
template <typename Check>
int status_of(Check check) {
  const pid_t pid = fork();
  if (pid == 0) _exit(check());
  int status = 0;
  waitpid(pid, &status, 0);
  return WEXITSTATUS(status);
}

TEST(Orphans, OfAProcessThatAdoptsThemAreKilledAndItsOwnChildrenAreNot) {
  EXPECT_EQ(status_of([] {
              become_subreaper();
              const pid_t own = waiting_child(), left = orphan();
              if (!exists(left)) return 1;
              kill_orphans();
              const bool right = !exists(left) && exists(own);
              kill(own, SIGKILL);
              return right ? 7 : 2;
            }),
            7);
}

TEST(Orphans, OfOtherProcessesAreLeftAlone) {
  EXPECT_EQ(status_of([] {
              prctl(PR_SET_CHILD_SUBREAPER, 1);  // not by become_subreaper()
              const pid_t left = orphan();
              kill_orphans();
              const bool right = exists(left);
              kill(left, SIGKILL);
              return right ? 7 : 2;
            }),
            7);
}

TEST(ChildProcesses, AreThoseOfAllThreadsUntilTheyAreWaitedFor) {
  EXPECT_EQ(child_processes(), std::vector<pid_t>());
  const pid_t child = waiting_child();
  EXPECT_EQ(child_processes(), std::vector<pid_t>{child});
  kill(child, SIGKILL);
  siginfo_t info;
  waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT);
  EXPECT_EQ(child_processes(), std::vector<pid_t>{child});
  waitpid(child, nullptr, 0);
  EXPECT_EQ(child_processes(), std::vector<pid_t>());
}

TEST(ChildProcesses, AreAlsoThoseThatSendNoSignalWhenTheyEnd) {
  if (syscall(SYS_clone, 0, nullptr, nullptr, nullptr, nullptr) == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // should it not be found
    wait_for_signals();
  }
  EXPECT_EQ(child_processes().size(), 1U);
  kill_children([](pid_t) { return false; });
  EXPECT_EQ(child_processes(), std::vector<pid_t>());
}

TEST(KillChildren, KeepsSome) {
  const pid_t kept = waiting_child();
  waiting_child();
  kill_children([=](pid_t child) { return child == kept; });
  EXPECT_EQ(child_processes(), std::vector<pid_t>{kept});
  kill_children([](pid_t) { return false; });
  EXPECT_EQ(child_processes(), std::vector<pid_t>());
}

}  // namespace
}  // namespace slalom
