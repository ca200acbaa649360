#include "worker_process.h"

#include <slalom/core/error.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

constexpr char kDone = 'D';
constexpr char kThrew = 'E';
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

/// The worker's life: it never returns to the code that forked it.
[[noreturn]] void serve(int socket, const WorkerTask& task) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_IGN);  // the parent decides what an interrupt means
  const int null_device = open("/dev/null", O_WRONLY);
  if (null_device >= 0) dup2(null_device, STDOUT_FILENO);
  std::uint64_t index = 0;
  while (receive_index(socket, index)) {
    try {
      send_answer(socket, kDone, task(index));
    } catch (const std::exception& e) {
      send_answer(socket, kThrew, reason_of(e));
    }
  }
  _exit(0);
}

std::string describe_end(int status) {
  if (WIFSIGNALED(status))
    return "killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  return "ended its process with exit status " + std::to_string(WEXITSTATUS(status));
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
    serve(ends[1], task);
  }
  close(ends[1]);
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  pid_ = pid;
  socket_ = ends[0];
  buffer_.clear();
}

void WorkerProcess::assign(std::size_t index) {
  const std::uint64_t wire = index;
  task_ = index;
  started_ = Clock::now();
  // A worker that is already dead shows at the next receive().
  send_all(socket_, reinterpret_cast<const char*>(&wire), sizeof wire);
}

std::optional<TaskResult> WorkerProcess::receive() {
  char chunk[65536];
  while (true) {
    const ssize_t got = recv(socket_, chunk, sizeof chunk, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    if (got <= 0) return died();
    buffer_.append(chunk, static_cast<std::size_t>(got));
  }
  if (buffer_.size() < kHeaderSize) return std::nullopt;
  std::uint64_t size = 0;
  std::memcpy(&size, buffer_.data() + 1, sizeof size);
  if ((buffer_[0] != kDone && buffer_[0] != kThrew) || size > kMaxPayload) {
    kill_and_reap();
    return TaskResult{TaskResult::Status::Crashed, "", "wrote garbage to its worker's connection"};
  }
  if (buffer_.size() < kHeaderSize + size) return std::nullopt;
  task_.reset();
  const bool done = buffer_[0] == kDone;
  std::string payload = buffer_.substr(kHeaderSize, size);
  buffer_.erase(0, kHeaderSize + size);
  if (done) return TaskResult{TaskResult::Status::Done, std::move(payload), ""};
  return TaskResult{TaskResult::Status::Crashed, "", std::move(payload)};
}

TaskResult WorkerProcess::time_out(double limit) {
  kill_and_reap();
  return {TaskResult::Status::TimedOut, "",
          "no answer within " + std::to_string(limit) + " s of wall-clock time"};
}

TaskResult WorkerProcess::died() {
  return {TaskResult::Status::Crashed, "", kill_and_reap()};
}

std::string WorkerProcess::kill_and_reap() {
  if (pid_ <= 0) return "";
  close(socket_);
  // The process may be dying by itself: its own end tells more than our signal, so look first.
  int status = 0;
  pid_t reaped = 0;
  for (int i = 0; i < 20 && reaped == 0 && busy(); ++i) {
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
  return describe_end(status);
}

}  // namespace slalom
