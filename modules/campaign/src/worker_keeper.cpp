#include "worker_keeper.h"
#include "worker_socket.h"

#include <slalom/core/fork.h>
#include <slalom/core/orphans.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
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

  /// Until the other end of the socket is closed.
  void run() {
    WorkerStart start;
    while (wait()) {
      for (std::size_t i = workers_.size(); i-- > 0;)
        if (is_released(workers_[i]) || has_ended(workers_[i].process)) end(i);
      const auto ended = [](pid_t cleaner) { return waitpid(cleaner, nullptr, WNOHANG) != 0; };
      cleaners_.erase(std::remove_if(cleaners_.begin(), cleaners_.end(), ended), cleaners_.end());
      if (!is_readable(socket_, 0)) continue;
      const KeeperRequest request = receive_keeper_request(socket_, start);
      if (request == KeeperRequest::End) break;
      if (request == KeeperRequest::Start) fork_worker(std::move(start));
      if (request == KeeperRequest::Reply) send_reply_request(socket_);
    }
    while (!workers_.empty()) end(workers_.size() - 1);
    for (const pid_t cleaner : cleaners_) waitpid(cleaner, nullptr, 0);
  }

 private:
  struct Worker {
    pid_t process;
    FileDescriptor control;
    std::string scratch;
  };

  bool wait() const {
    std::vector<pollfd> events = {{ends_.number(), POLLIN, 0}, {socket_, POLLIN, 0}};
    for (const Worker& worker : workers_) events.push_back({worker.control.number(), POLLIN, 0});
    if (poll(events.data(), events.size(), -1) < 0) return errno == EINTR;
    signalfd_siginfo ignored;
    return events[0].revents == 0 || read(ends_.number(), &ignored, sizeof ignored) > 0;
  }

  static bool is_released(const Worker& worker) { return is_readable(worker.control.number(), 0); }

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
    if (worker < 0) end(workers_.size() - 1);
  }

  /// Kills the worker's group, then what it leaves to this process, which other workers do not.
  void end(std::size_t index) {
    const Worker worker = std::move(workers_[index]);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(index));
    int status = kNoWorker;
    if (worker.process > 0) {
      kill(-worker.process, SIGKILL);
      kill(worker.process, SIGKILL);  // it may not have its own group yet
      waitpid(worker.process, &status, 0);
      kill_children([this](pid_t child) {
        return std::any_of(workers_.begin(), workers_.end(),
                           [=](const Worker& one) { return one.process == child; }) ||
               std::find(cleaners_.begin(), cleaners_.end(), child) != cleaners_.end();
      });
    }
    if (!worker.scratch.empty()) remove_folder(worker.scratch);
    send(worker.control.number(), &status, sizeof status, MSG_NOSIGNAL);
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
  FileDescriptor ends_;  ///< readable when a child has ended
  std::vector<Worker> workers_;
  std::vector<pid_t> cleaners_;  ///< processes that remove folders
};

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
  char reply = 0;
  bool replies = send_reply_request(socket_.number());
  while (replies && recv(socket_.number(), &reply, sizeof reply, 0) < 1) replies = errno == EINTR;
  if (!replies) end();
  return replies;
}

void WorkerKeeper::begin() {
  SocketPair ends(SOCK_SEQPACKET);
  process_ = fork_process();
  if (process_ < 0) throw cannot_create("process", errno);
  if (process_ == 0) {
    const int socket = ends.far_end.number();
    drop_descriptors(keep_stderr_, socket, socket);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
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
  socket_ = FileDescriptor();
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  if (WIFSIGNALED(status)) kill_orphans();
}

}  // namespace slalom
