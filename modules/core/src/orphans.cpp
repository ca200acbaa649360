#include <slalom/core/orphans.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace slalom {
namespace {

bool is_adopting = false;

}  // namespace

void adopt_orphans() {
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

void kill_children(const std::function<bool(pid_t child)>& is_kept) {
  constexpr int kMaxPasses = 10000;  // against processes that keep forking
  bool is_last = false;
  for (int pass = 0; pass < kMaxPasses && !is_last; ++pass) {
    is_last = true;
    for (const pid_t child : child_processes()) {
      if (is_kept(child)) continue;
      is_last = false;
      if (kill(child, SIGKILL) == 0) waitpid(child, nullptr, __WALL);
    }
  }
}

void kill_orphans() {
  if (!is_adopting) return;
  const pid_t session = getsid(0);
  kill_children([=](pid_t child) { return getsid(child) == session; });
}

}  // namespace slalom
