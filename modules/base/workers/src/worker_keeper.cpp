// SPDX-License-Identifier: BSD-3-Clause
#include "worker_keeper.h"
#include "worker_socket.h"

#include <slalom/core/fork.h>
#include <slalom/core/orphans.h>
#include <slalom/workers/process_state.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace slalom {
namespace {

using Serve = std::function<void(const WorkerStart&)>;

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

/// How often and long a keeper may be found stopped, or held by its tracer when it has ended. A
/// program that is suspended with its keeper and continued finds it running.
constexpr int kMaxStopped = 50, kCheckMs = 20;
/// How often it may be found silent while this process waits for it: a minute. It is killed then.
constexpr int kMaxSilent = 3000;

/// Whether a signal or a tracing process has stopped the process.
bool is_stopped(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string fields;
  std::getline(file, fields);
  const std::size_t name_end = fields.rfind(") ");
  if (name_end == std::string::npos) return false;
  const char state = fields[name_end + 2];
  return state == 'T' || state == 't';
}

/// The main loop of a keeper's process.
class Keeper {
 public:
  /// `signals`: all are blocked but those that this set contains are to be in workers.
  Keeper(int socket, const Serve& serve, const sigset_t& signals)
      : socket_(socket), serve_(serve), signals_of_workers_(signals) {
    sigset_t child;
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    ends_ = FileDescriptor(signalfd(-1, &child, 0));
  }

  /// Until the other end of the socket is closed. It never waits for a process that is to end.
  void run() {
    WorkerStart start;
    while (!is_ending_ || !workers_.empty()) {
      wait();
      // A process whose limits a method lowered is replaced as one that a method killed. Already
      // poll() fails where there may be fewer descriptors than it waits for.
      if (!limits_.restore_lowered().empty()) raise(SIGKILL);
      end_workers();
      clean_up();
      if (is_ending_ || !has_request_) continue;
      const KeeperRequest request = receive_keeper_request(socket_, start);
      if (request == KeeperRequest::Broken) raise(SIGKILL);
      if (request == KeeperRequest::End) is_ending_ = true;
      if (request == KeeperRequest::Start) fork_worker(std::move(start));
      if (request == KeeperRequest::Reply) send_reply_request(socket_);
    }
    for (const pid_t cleaner : cleaners_) waitpid(cleaner, nullptr, 0);
  }

 private:
  struct Worker {
    pid_t process;
    FileDescriptor control;
    std::string scratch;
    bool is_released = false, is_killed = false, is_reaped = false;
    int status = kNoWorker;
  };

  /// Notes which workers are released, and whether any has ended: only then all are looked at.
  void wait() {
    std::vector<pollfd> events = {{ends_.number(), POLLIN, 0}, {socket_, POLLIN, 0}};
    if (is_ending_) events[1].fd = -1;
    for (const Worker& worker : workers_)
      events.push_back({worker.is_killed ? -1 : worker.control.number(), POLLIN, 0});
    const bool is_killing = std::any_of(workers_.begin(), workers_.end(), is_reaped);
    poll(events.data(), events.size(), is_ending_ || is_killing ? 1 : -1);
    signalfd_siginfo ignored;
    has_end_ = events[0].revents != 0;
    if (has_end_) (void)!read(ends_.number(), &ignored, sizeof ignored);
    for (std::size_t i = 0; i < workers_.size(); ++i)
      workers_[i].is_released = is_ending_ || events[i + 2].revents != 0;
    has_request_ = events[1].revents != 0;
  }

  static bool is_reaped(const Worker& worker) { return worker.is_reaped; }

  void fork_worker(WorkerStart start) {
    const pid_t keeper = getpid();
    const pid_t worker = fork_process();
    if (worker == 0) {
      setsid();
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      prctl(PR_SET_CHILD_SUBREAPER, 1);   // so that it notices daemons that a method started
      if (getppid() != keeper) _exit(1);  // the keeper died before prctl()
      sigprocmask(SIG_SETMASK, &signals_of_workers_, nullptr);
      serve_(start);
      _exit(0);
    }
    workers_.push_back({worker, std::move(start.control), std::move(start.scratch)});
    if (worker < 0) workers_.back().is_killed = workers_.back().is_reaped = true;
  }

  /// Kills the groups of the workers that have ended or are to, and reaps those.
  void end_workers() {
    for (Worker& worker : workers_) {
      if (!worker.is_killed && (worker.is_released || (has_end_ && has_ended(worker.process)))) {
        kill(-worker.process, SIGKILL);
        kill(worker.process, SIGKILL);  // it may not have its own group yet
        worker.is_killed = true;
      }
      if (worker.is_killed && !worker.is_reaped)
        worker.is_reaped = waitpid(worker.process, &worker.status, WNOHANG) != 0;
    }
  }

  /// Kills what the reaped workers left to this process, which others do not. When there is
  /// nothing more, reports their ends.
  void clean_up() {
    const auto ended = [](pid_t cleaner) { return waitpid(cleaner, nullptr, WNOHANG) != 0; };
    cleaners_.erase(std::remove_if(cleaners_.begin(), cleaners_.end(), ended), cleaners_.end());
    const auto reaped = std::stable_partition(
        workers_.begin(), workers_.end(), [](const Worker& worker) { return !worker.is_reaped; });
    if (reaped == workers_.end()) return;
    const bool are_left = kill_present_children([&](pid_t child) {
      return std::any_of(workers_.begin(), reaped,
                         [=](const Worker& one) { return one.process == child; }) ||
             std::find(cleaners_.begin(), cleaners_.end(), child) != cleaners_.end();
    });
    if (are_left && ++kills_ < kMaxKills) return;
    kills_ = 0;
    for (auto worker = reaped; worker != workers_.end(); ++worker) {
      if (!worker->scratch.empty()) remove_folder(worker->scratch);
      send(worker->control.number(), &worker->status, sizeof worker->status, MSG_NOSIGNAL);
    }
    workers_.erase(reaped, workers_.end());
  }

  /// In a process of its own, since methods may leave millions of files while others wait for this
  /// process. It outlives a keeper that is killed.
  void remove_folder(const std::string& folder) {
    const pid_t cleaner = fork_process();
    if (cleaner > 0) return cleaners_.push_back(cleaner);
    // Its copies of sockets would hide that this process has ended.
    if (cleaner == 0) close_range_of_descriptors(STDERR_FILENO + 1, ~0U);
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    if (cleaner == 0) _exit(0);
  }

  int socket_;
  const Serve& serve_;
  sigset_t signals_of_workers_;
  ResourceLimits limits_;
  FileDescriptor ends_;  ///< readable when a child has ended
  bool is_ending_ = false, has_end_ = false, has_request_ = false;
  std::vector<Worker> workers_;
  int kills_ = 0;                ///< of what the reaped workers left, until now
  std::vector<pid_t> cleaners_;  ///< processes that remove folders
};

}  // namespace

void drop_descriptors(bool keep_stderr, std::vector<int> kept) {
  const int null_device = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (stream != STDERR_FILENO || !keep_stderr) dup2(null_device, stream);
  std::sort(kept.begin(), kept.end());
  unsigned first = STDERR_FILENO + 1;
  for (const int one : kept) {
    const auto number = static_cast<unsigned>(one);
    close_range_of_descriptors(first, number - 1);
    first = number + 1;
  }
  close_range_of_descriptors(first, ~0U);
}

WorkerKeeper::WorkerKeeper(bool keep_stderr, Serve serve)
    : keep_stderr_(keep_stderr), serve_(std::move(serve)) {}

WorkerKeeper::~WorkerKeeper() {
  end();
}

void WorkerKeeper::start_worker(const WorkerStart& start) {
  if (is_alive() && send_start(socket_.number(), start)) return;
  end();
  begin();
  if (!send_start(socket_.number(), start)) throw cannot_create("process", errno);
}

/// A process with a pending SIGKILL executes nothing more: whoever replies had none when asked.
bool WorkerKeeper::is_alive() {
  if (process_ < 0) return false;
  const bool replies = send_reply_request(socket_.number()) && await_message();
  if (!replies) end();
  return replies;
}

void WorkerKeeper::kill_if_stopped() {
  stopped_ = process_ > 0 && is_stopped(process_) ? stopped_ + 1 : 0;
  if (stopped_ >= kMaxStopped) kill(process_, SIGKILL);
}

/// False when the connection has ended, or the process does not even end.
bool WorkerKeeper::await_message() {
  for (int silent = 0; !is_readable(socket_.number(), kCheckMs); ++silent) {
    kill_if_stopped();
    if (silent == kMaxSilent) kill(process_, SIGKILL);
    if (silent == kMaxSilent + kMaxStopped) return false;
  }
  char message = 0;
  ssize_t got = 0;
  do {
    got = recv(socket_.number(), &message, sizeof message, 0);
  } while (got < 0 && errno == EINTR);
  return got > 0;
}

void WorkerKeeper::begin() {
  SocketPair ends(SOCK_SEQPACKET);
  // Otherwise workers would print it once more.
  std::cout.flush();
  std::fflush(stdout);
  process_ = fork_process();
  if (process_ < 0) throw cannot_create("process", errno);
  if (process_ == 0) {
    const int socket = ends.far_end.number();
    drop_descriptors(keep_stderr_, {socket});
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    prctl(PR_SET_PDEATHSIG, SIGCONT);  // one that is stopped notices that the connection has ended
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, &before);
    Keeper(socket, serve_, before).run();
    _exit(0);
  }
  socket_ = std::move(ends.near_end);
  ++generation_;
}

void WorkerKeeper::end() {
  if (process_ < 0) return;
  shutdown(socket_.number(), SHUT_WR);
  while (await_message()) continue;
  socket_ = FileDescriptor();
  int status = 0;
  // A process that is traced is left to its tracer first.
  for (int i = 0; i < kMaxStopped && waitpid(process_, &status, WNOHANG) == 0; ++i) {
    kill_orphans();
    poll(nullptr, 0, kCheckMs);
  }
  process_ = -1;
  if (WIFSIGNALED(status)) kill_orphans();
}

}  // namespace slalom
