#include "worker_keeper.h"

#include <slalom/core/fork.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <string>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

void close_range_of_descriptors(unsigned first, unsigned last) {
  if (first > last || syscall(SYS_close_range, first, last, 0) == 0) return;
  const auto most = static_cast<unsigned>(sysconf(_SC_OPEN_MAX));  // before Linux 5.9
  for (unsigned file = first; file <= std::min(last, most); ++file) close(static_cast<int>(file));
}

/// Whether the worker has ended. It is not reaped, so that its number is not used again.
bool has_ended(pid_t worker) {
  siginfo_t info = {};
  return waitid(P_PID, static_cast<id_t>(worker), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == worker;
}

/// Until the worker ends or `control` is closed.
void watch(pid_t worker, int control, int signals) {
  while (!has_ended(worker)) {
    pollfd events[] = {{signals, POLLIN, 0}, {control, POLLIN, 0}};
    if (poll(events, 2, -1) < 0 && errno != EINTR) return;
    if (events[1].revents != 0) return;
    signalfd_siginfo ignored;
    if (events[0].revents != 0 && read(signals, &ignored, sizeof ignored) < 0) return;
  }
}

/// Kills the worker's group, then all children until there are none: the children of those killed
/// become children of this process. Returns the worker's status.
int kill_all(pid_t worker) {
  constexpr int kMaxPasses = 10000;  // against processes that keep forking
  int status = 0;
  kill(-worker, SIGKILL);
  kill(worker, SIGKILL);  // it may not have its own group yet
  waitpid(worker, &status, 0);
  const std::string list =
      "/proc/self/task/" + std::to_string(getpid()) + "/children";  // this process has one thread
  for (int pass = 0; pass < kMaxPasses && waitpid(-1, nullptr, WNOHANG) >= 0; ++pass) {
    std::ifstream children(list);
    for (pid_t child = 0; children >> child;) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
  }
  return status;
}

}  // namespace

void drop_descriptors(bool keep_stderr, int kept, int also_kept) {
  const int null_device = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (stream != STDERR_FILENO || !keep_stderr) dup2(null_device, stream);
  const auto low = static_cast<unsigned>(std::min(kept, also_kept));
  const auto high = static_cast<unsigned>(std::max(kept, also_kept));
  close_range_of_descriptors(STDERR_FILENO + 1, low - 1);
  close_range_of_descriptors(low + 1, high - 1);
  close_range_of_descriptors(high + 1, ~0U);
}

void keep_worker(int control, const std::string& scratch, const std::function<void()>& serve) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &before);
  const pid_t keeper = getpid();
  const pid_t worker = fork_process();
  if (worker == 0) {
    close(control);
    setsid();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_CHILD_SUBREAPER, 1);   // so that it notices daemons that a method started
    if (getppid() != keeper) _exit(1);  // the keeper died before prctl()
    sigprocmask(SIG_SETMASK, &before, nullptr);
    serve();
    _exit(0);
  }
  int status = kNoWorker;
  if (worker > 0) {
    sigset_t child;
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    drop_descriptors(true, control,
                     control);  // of the worker's socket its process has the only one
    watch(worker, control, signalfd(-1, &child, 0));
    status = kill_all(worker);
  }
  std::error_code ignored;
  if (!scratch.empty()) std::filesystem::remove_all(scratch, ignored);
  send(control, &status, sizeof status, MSG_NOSIGNAL);
  _exit(0);
}

}  // namespace slalom
