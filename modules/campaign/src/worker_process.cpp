#include "worker_limits.h"
#include "worker_process.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <new>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

constexpr char kDone = 'D';
constexpr char kThrew = 'E';
constexpr char kOutOfMemory = 'M';
constexpr std::size_t kHeaderSize = 1 + sizeof(std::uint64_t);
/// Larger than any valid payload; a larger size means corrupted data.
constexpr std::uint64_t kMaxPayload = std::uint64_t{1} << 30;

bool send_all(int socket, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t sent = send(socket, data, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    data += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_index(int socket, std::uint64_t& index) {
  ssize_t got = 0;
  do {
    got = recv(socket, &index, sizeof index, MSG_WAITALL);
  } while (got < 0 && errno == EINTR);
  return got == static_cast<ssize_t>(sizeof index);
}

void send_answer(int socket, char kind, const std::string& payload) {
  const std::uint64_t size = payload.size();
  std::string message(1, kind);
  message.append(reinterpret_cast<const char*>(&size), sizeof size);
  message += payload;
  if (!send_all(socket, message.data(), message.size())) _exit(1);
}

void discard(int file, int null_device) {
  if (null_device >= 0) dup2(null_device, file);
}

void answer(int socket, const WorkItem& item, std::size_t index, SharedTaskLog& log) {
  try {
    send_answer(socket, kDone, item(index, log));
  } catch (const std::bad_alloc&) {
    send_answer(socket, kOutOfMemory, "out of memory");
  } catch (const std::exception& e) {
    send_answer(socket, kThrew, reason_of(e));
  }
}

/// The main loop of a worker process.
[[noreturn]] void serve(int socket, const WorkItem& item, const PoolOptions& options,
                        SharedTaskLog& log) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_IGN);  // interrupts are handled by the parent
  const int null_device = open("/dev/null", O_WRONLY | O_CLOEXEC);
  discard(STDOUT_FILENO, null_device);
  if (!options.keep_stderr) discard(STDERR_FILENO, null_device);
  limit_memory(static_cast<std::size_t>(options.memory_mb * 1024 * 1024));
  std::uint64_t index = 0;
  while (receive_index(socket, index)) {
    limit_cpu_time(options.item_cpu_time);
    answer(socket, item, index, log);
  }
  if (options.at_end) options.at_end();
  _exit(0);
}

std::string describe_end(int status) {
  if (WIFSIGNALED(status))
    return "killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  return "process exited with status " + std::to_string(WEXITSTATUS(status));
}

bool is_out_of_cpu_time(int status) {
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
}

}  // namespace

void WorkerProcess::start(const WorkItem& item, std::size_t group) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw job_error("workers",
                    std::string("cannot create a socket (") + std::strerror(errno) + ")");
  const pid_t pid = fork();
  if (pid < 0) {
    close(ends[0]);
    close(ends[1]);
    throw job_error("workers",
                    std::string("cannot create a process (") + std::strerror(errno) + ")");
  }
  if (pid == 0) {
    close(ends[0]);
    serve(ends[1], item, options_, log_);
  }
  close(ends[1]);
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  pid_ = pid;
  socket_ = ends[0];
  group_ = group;
  buffer_.clear();
}

void WorkerProcess::assign(std::size_t index) {
  const std::uint64_t wire = index;
  log_.clear();
  heartbeats_ = 0;
  item_ = index;
  busy_ = true;
  started_ = last_heartbeat_ = options_.clock();
  // The death of a worker is detected by the next receive().
  send_all(socket_, reinterpret_cast<const char*>(&wire), sizeof wire);
}

std::optional<WorkResult> WorkerProcess::receive() {
  if (auto result = read_answer()) return result;
  const std::string limit = exceeded_limit();
  if (limit.empty()) return std::nullopt;
  kill(pid_, SIGKILL);
  return end(Status::TimedOut, limit);
}

std::optional<WorkResult> WorkerProcess::read_answer() {
  char chunk[65536];
  while (true) {
    const ssize_t got = recv(socket_, chunk, sizeof chunk, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    if (got <= 0) return end(Status::Crashed, "");
    buffer_.append(chunk, static_cast<std::size_t>(got));
  }
  if (buffer_.size() < kHeaderSize) return std::nullopt;
  const char kind = buffer_[0];
  std::uint64_t size = 0;
  std::memcpy(&size, buffer_.data() + 1, sizeof size);
  if ((kind != kDone && kind != kThrew && kind != kOutOfMemory) || size > kMaxPayload) {
    kill(pid_, SIGKILL);
    return end(Status::Crashed, "wrote invalid data to the worker's socket");
  }
  if (buffer_.size() < kHeaderSize + size) return std::nullopt;
  std::string payload = buffer_.substr(kHeaderSize, size);
  if (kind != kDone) {
    kill(pid_, SIGKILL);
    return end(kind == kThrew ? Status::Threw : Status::OutOfMemory, std::move(payload));
  }
  buffer_.clear();
  busy_ = false;
  if (log_.is_retired()) kill_and_reap();
  return WorkResult{Status::Done, std::move(payload), "", ""};
}

std::string WorkerProcess::exceeded_limit() {
  // The clock is read first: a heartbeat in between must not count as missing.
  const double now = options_.clock();
  const std::uint64_t heartbeats = log_.heartbeats();
  if (heartbeats != heartbeats_) {
    heartbeats_ = heartbeats;
    last_heartbeat_ = now;
  }
  if (options_.heartbeat_timeout > 0 && heartbeats_ > 0 &&
      now - last_heartbeat_ > options_.heartbeat_timeout)
    return "no response within " + format_number(options_.heartbeat_timeout) + " s";
  if (options_.item_wall_time > 0 && now - started_ > options_.item_wall_time)
    return "wall-clock time limit of " + format_number(options_.item_wall_time) + " s exceeded";
  return "";
}

WorkResult WorkerProcess::end(Status status, std::string reason) {
  const int wait_status = reap();
  if (status == Status::Crashed && is_out_of_cpu_time(wait_status)) {
    status = Status::TimedOut;
    reason = "CPU time limit of " + format_number(options_.item_cpu_time) + " s exceeded";
  }
  if (reason.empty()) reason = describe_end(wait_status);
  return {status, "", std::move(reason), log_.contents()};
}

void WorkerProcess::kill_and_reap() {
  if (pid_ <= 0) return;
  kill(pid_, SIGKILL);
  reap();
}

void WorkerProcess::request_end() {
  if (idle()) shutdown(socket_, SHUT_WR);
}

void WorkerProcess::await_end() {
  if (!alive()) return;
  pollfd end = {socket_, POLLIN, 0};
  poll(&end, 1, static_cast<int>(kOrderlyEnd * 1000));
  kill_and_reap();
}

int WorkerProcess::reap() {
  close(socket_);
  int status = 0;
  // If the process is already terminating, prefer its own exit status to that of our signal.
  pid_t reaped = 0;
  for (int i = 0; i < 20 && reaped == 0; ++i) {
    reaped = waitpid(pid_, &status, WNOHANG);
    if (reaped == 0) usleep(500);
  }
  if (reaped == 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, &status, 0);
  }
  pid_ = -1;
  socket_ = -1;
  busy_ = false;
  return status;
}

}  // namespace slalom
