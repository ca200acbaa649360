// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/fork.h>

#include <gtest/gtest.h>

#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

std::string* order = nullptr;

TEST(ForkProcess, RunsTheHooksAroundTheForkInEachProcess) {
  std::string seen;
  order = &seen;
  set_fork_hooks(
      {[] { *order += "before "; }, [] { *order += "parent"; }, [] { *order += "child"; }});
  const pid_t pid = fork_process();
  if (pid == 0) _exit(seen == "before child" ? 7 : 1);
  set_fork_hooks({});
  int status = 0;
  ASSERT_EQ(waitpid(pid, &status, 0), pid);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(seen, "before parent");
}

TEST(ForkProcess, IsAForkWithoutHooks) {
  const pid_t pid = fork_process();
  if (pid == 0) _exit(7);
  int status = 0;
  ASSERT_EQ(waitpid(pid, &status, 0), pid);
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

}  // namespace
}  // namespace slalom
