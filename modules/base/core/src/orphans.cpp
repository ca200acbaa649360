// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/orphans.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace slalom {
namespace {

bool is_adopting = false;

}  // namespace

void become_subreaper() {
  is_adopting = prctl(PR_SET_CHILD_SUBREAPER, 1) == 0;
}

std::vector<pid_t> child_processes() {
  // __WALL: also children of clone() that send no SIGCHLD when they end.
  siginfo_t info;
  if (waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT | __WALL) != 0) return {};  // usually
  std::vector<pid_t> pids;
  std::error_code error;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", error)) {
    std::ifstream list(thread.path() / "children");
    for (pid_t pid = 0; list >> pid;) pids.push_back(pid);
  }
  return pids;
}

bool kill_present_children(const std::function<bool(pid_t child)>& is_kept) {
  std::vector<pid_t> children = child_processes();
  children.erase(std::remove_if(children.begin(), children.end(), is_kept), children.end());
  for (const pid_t child : children) kill(child, SIGKILL);
  // Not waiting: one that is traced is left to its tracer, which may be among them, first.
  for (const pid_t child : children) waitpid(child, nullptr, WNOHANG | __WALL);
  return !children.empty();
}

void kill_children(const std::function<bool(pid_t child)>& is_kept) {
  for (int i = 0; i < kMaxKills && kill_present_children(is_kept); ++i) poll(nullptr, 0, 1);
}

void kill_orphans() {
  if (!is_adopting) return;
  const pid_t session = getsid(0);
  kill_children([=](pid_t child) { return getsid(child) == session; });
}

}  // namespace slalom
