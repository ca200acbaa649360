#include "worker_keeper.h"
#include "worker_limits.h"
#include "worker_process.h"
#include "worker_sandbox.h"
#include "worker_socket.h"

#include <slalom/core/error.h>
#include <slalom/core/fork.h>
#include <slalom/core/text.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <new>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace slalom {
namespace {

/// Larger than any valid payload; a larger size means corrupted data.
constexpr std::uint64_t kMaxPayload = std::uint64_t{1} << 30;

struct Answer {
  char kind;
  std::string payload;
};

Answer execute(const WorkItem& item, std::size_t index, SharedTaskLog& log, FileDescriptor file,
               const FileReceiver& receive_file) {
  try {
    if (file) receive_file(index, file.number());
    file = FileDescriptor();
    return {kDone, item(index, log)};
  } catch (const std::bad_alloc&) {
    return {kOutOfMemory, "out of memory"};
  } catch (const std::exception& e) {
    return {kThrew, reason_of(e)};
  }
}

/// The main loop of a worker process.
void serve(int socket, const WorkItem& item, const PoolOptions& options,
           const FileReceiver& receive_file, SharedTaskLog& log) {
  // Interrupts are handled by the parent.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  limit_memory(static_cast<std::size_t>(options.memory_mb * 1024 * 1024));
  const pid_t self = getpid();
  Request request = {};
  FileDescriptor file;
  while (receive_request(socket, request, file)) {
    limit_cpu_time(options.item_cpu_time);
    const Answer answer = execute(item, request.index, log, std::move(file), receive_file);
    if (getpid() != self) return;  // a copy, made by a method that forked
    if (!send_answer(socket, request, answer.kind, answer.payload))
      return log.report_disconnected();
  }
  if (options.at_end) options.at_end();
}

/// A worker without its sandbox must not run a method.
void enter_sandbox(const std::string& scratch, std::vector<std::string> writable) {
  writable.push_back(scratch);
  setenv("TMPDIR", scratch.c_str(), 1);
  if (!confine_writing_to(writable)) _exit(EXIT_FAILURE);
}

std::string describe_status(int status) {
  if (WIFSIGNALED(status))
    return "killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  return "process exited with status " + std::to_string(WEXITSTATUS(status));
}

bool was_killed_by(int status, int signal) {
  return WIFSIGNALED(status) && WTERMSIG(status) == signal;
}

}  // namespace

void WorkerProcess::start(const WorkItem& item, std::size_t group) {
  SocketPair work, control;
  const std::string scratch = options_.sandbox ? make_scratch_folder() : "";
  if (options_.sandbox && scratch.empty()) throw cannot_create("folder for temporary files", errno);
  const pid_t pid = fork_process();
  if (pid < 0) throw cannot_create("process", errno);
  if (pid == 0) {
    const int socket = work.far_end.number(), keeper = control.far_end.number();
    drop_descriptors(options_.keep_stderr, socket, keeper);
    const auto serve_items = [&] {
      if (options_.sandbox) enter_sandbox(scratch, options_.writable);
      serve(socket, item, options_, receive_file_, log_);
    };
    if (!options_.trusted) keep_worker(keeper, scratch, serve_items);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    serve_items();
    _exit(0);
  }
  child_ = pid;
  socket_ = work.near_end.take();
  control_ = control.near_end.take();
  fcntl(socket_, F_SETFL, O_NONBLOCK);
  disconnected_ = false;
  group_ = group;
  buffer_.clear();
}

bool WorkerProcess::is_sound() const {
  return !is_readable(socket_, 0) && !is_readable(control_, 0);
}

void WorkerProcess::assign(std::size_t index, int file) {
  nonce_ = std::uint64_t{random_()} << 32U | random_();
  const Request request = {nonce_, index};
  log_.clear();
  heartbeats_ = 0;
  item_ = index;
  busy_ = true;
  started_ = last_heartbeat_ = options_.clock();
  // The death of a worker is detected by the next receive().
  send_request(socket_, request, file);
}

void WorkerProcess::add_events(std::vector<pollfd>& events) const {
  if (!busy_) return;
  if (!disconnected_) events.push_back({socket_, POLLIN, 0});
  events.push_back({control_, POLLIN, 0});
}

std::optional<WorkResult> WorkerProcess::receive() {
  // In this order: a process may answer and then die.
  const bool has_died = is_readable(control_, 0);
  read_socket();
  if (auto result = take_answer()) return result;
  if (has_died) return describe_end();
  const std::string limit = exceeded_limit();
  if (limit.empty()) return std::nullopt;
  return kill_with(Status::TimedOut, limit);
}

void WorkerProcess::read_socket() {
  char chunk[65536];
  while (!disconnected_) {
    const ssize_t got = recv(socket_, chunk, sizeof chunk, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    disconnected_ = got <= 0;
    if (got > 0) buffer_.append(chunk, static_cast<std::size_t>(got));
  }
}

std::optional<WorkResult> WorkerProcess::take_answer() {
  AnswerHeader header = {};
  if (buffer_.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, buffer_.data(), sizeof header);
  const bool is_known =
      header.kind == kDone || header.kind == kThrew || header.kind == kOutOfMemory;
  if (!is_known || header.size > kMaxPayload)
    return kill_with(Status::Crashed, "wrote invalid data to the worker's socket");
  if (header.request.nonce != nonce_ || header.request.index != item_)
    return kill_with(Status::Crashed, "answered a request that had not been made");
  if (buffer_.size() < sizeof header + header.size) return std::nullopt;
  std::string payload = buffer_.substr(sizeof header, header.size);
  if (header.kind == kThrew) return kill_with(Status::Threw, std::move(payload));
  if (header.kind == kOutOfMemory) return kill_with(Status::OutOfMemory, std::move(payload));
  if (options_.is_valid && !options_.is_valid(item_, payload))
    return kill_with(Status::Crashed, kInvalidPayload);
  const bool has_more = buffer_.size() > sizeof header + header.size;
  buffer_.clear();
  busy_ = false;
  if (log_.is_retired() || has_more || disconnected_) kill_and_reap();
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

WorkResult WorkerProcess::kill_with(Status status, std::string reason) {
  kill_and_reap();
  return {status, "", std::move(reason), log_.contents()};
}

std::optional<int> WorkerProcess::end_status() {
  int status = 0;
  if (recv(control_, &status, sizeof status, 0) == sizeof status) return status;
  if (!options_.trusted) return std::nullopt;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) continue;
  child_ = -1;
  return status;
}

WorkResult WorkerProcess::describe_end() {
  const std::optional<int> ended = end_status();
  if (!ended) return kill_with(Status::Killed, "its supervising process was killed");
  const int status = *ended;
  if (status == kNoWorker) throw cannot_create("process", EAGAIN);
  if (was_killed_by(status, SIGXCPU))
    return kill_with(Status::TimedOut,
                     "CPU time limit of " + format_number(options_.item_cpu_time) + " s exceeded");
  if (was_killed_by(status, SIGKILL)) return kill_with(Status::Killed, describe_status(status));
  if (log_.is_disconnected())
    return kill_with(Status::Crashed, "closed the worker's connection to the simulator");
  return kill_with(Status::Crashed, describe_status(status));
}

void WorkerProcess::kill_and_reap() {
  if (socket_ < 0) return;
  close(socket_);
  close(control_);  // the keeper kills the worker and whatever it started, then exits
  if (options_.trusted && child_ > 0) kill(child_, SIGKILL);
  while (child_ > 0 && waitpid(child_, nullptr, 0) < 0 && errno == EINTR) continue;
  child_ = socket_ = control_ = -1;
  busy_ = false;
}

void WorkerProcess::request_end() {
  if (idle()) shutdown(socket_, SHUT_WR);
}

void WorkerProcess::await_end() {
  if (idle()) is_readable(control_, static_cast<int>(kOrderlyEnd * 1000));
  kill_and_reap();
}

}  // namespace slalom
