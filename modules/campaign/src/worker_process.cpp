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
/// More than any run can honestly need; a larger announced size is garbage.
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

void answer(int socket, const WorkerTask& task, std::size_t index, TaskNotes& notes) {
  try {
    send_answer(socket, kDone, task(index, notes));
  } catch (const std::bad_alloc&) {
    send_answer(socket, kOutOfMemory, "out of memory");
  } catch (const std::exception& e) {
    send_answer(socket, kThrew, reason_of(e));
  }
}

/// The worker's life: it never returns to the code that forked it.
[[noreturn]] void serve(int socket, const WorkerTask& task, const PoolOptions& options,
                        TaskNotes& notes) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_IGN);  // the parent decides what an interrupt means
  const int null_device = open("/dev/null", O_WRONLY | O_CLOEXEC);
  discard(STDOUT_FILENO, null_device);
  if (!options.keep_errors) discard(STDERR_FILENO, null_device);
  limit_memory(static_cast<std::size_t>(options.memory_mb * 1024 * 1024));
  std::uint64_t index = 0;
  while (receive_index(socket, index)) {
    limit_cpu_time(options.task_cpu_time);
    answer(socket, task, index, notes);
  }
  _exit(0);
}

std::string describe_end(int status) {
  if (WIFSIGNALED(status))
    return "killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  return "ended its process with exit status " + std::to_string(WEXITSTATUS(status));
}

bool is_out_of_cpu_time(int status) {
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
}

double seconds_since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

}  // namespace

void WorkerProcess::start(const WorkerTask& task) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw job_error("workers", std::string("no socket can be made (") + std::strerror(errno) + ")");
  const pid_t pid = fork();
  if (pid < 0) {
    close(ends[0]);
    close(ends[1]);
    throw job_error("workers",
                    std::string("no process can be made (") + std::strerror(errno) + ")");
  }
  if (pid == 0) {
    close(ends[0]);
    serve(ends[1], task, options_, notes_);
  }
  close(ends[1]);
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  pid_ = pid;
  socket_ = ends[0];
  buffer_.clear();
}

void WorkerProcess::assign(std::size_t index) {
  const std::uint64_t wire = index;
  notes_.clear();
  beats_ = 0;
  task_ = index;
  started_ = last_beat_ = Clock::now();
  // A worker that is already dead shows at the next receive().
  send_all(socket_, reinterpret_cast<const char*>(&wire), sizeof wire);
}

std::optional<TaskResult> WorkerProcess::receive() {
  if (auto result = read_answer()) return result;
  const std::string limit = passed_limit();
  if (limit.empty()) return std::nullopt;
  kill(pid_, SIGKILL);
  return end(Status::TimedOut, limit);
}

std::optional<TaskResult> WorkerProcess::read_answer() {
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
    return end(Status::Crashed, "wrote garbage to its worker's connection");
  }
  if (buffer_.size() < kHeaderSize + size) return std::nullopt;
  std::string payload = buffer_.substr(kHeaderSize, size);
  if (kind != kDone) {
    kill(pid_, SIGKILL);
    return end(kind == kThrew ? Status::Threw : Status::OutOfMemory, std::move(payload));
  }
  buffer_.clear();
  task_.reset();
  if (notes_.is_retired()) kill_and_reap();
  return TaskResult{Status::Done, std::move(payload), "", ""};
}

std::string WorkerProcess::passed_limit() {
  if (notes_.beats() != beats_) {
    beats_ = notes_.beats();
    last_beat_ = Clock::now();
  }
  if (options_.silence > 0 && beats_ > 0 && seconds_since(last_beat_) > options_.silence)
    return "no answer within " + format_number(options_.silence) + " s of a cycle";
  if (options_.task_wall_time > 0 && seconds_since(started_) > options_.task_wall_time)
    return "not done within " + format_number(options_.task_wall_time) + " s of wall-clock time";
  return "";
}

TaskResult WorkerProcess::end(Status status, std::string why) {
  const int how = reap();
  if (status == Status::Crashed && is_out_of_cpu_time(how)) {
    status = Status::TimedOut;
    why = "used up " + format_number(options_.task_cpu_time) + " s of processor time";
  }
  if (why.empty()) why = describe_end(how);
  return {status, "", std::move(why), notes_.contents()};
}

void WorkerProcess::kill_and_reap() {
  if (pid_ <= 0) return;
  kill(pid_, SIGKILL);
  reap();
}

int WorkerProcess::reap() {
  close(socket_);
  int status = 0;
  // The process may be dying by itself: its own end tells more than our signal, so look first.
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
  task_.reset();
  return status;
}

}  // namespace slalom
