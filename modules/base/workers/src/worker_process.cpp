// SPDX-License-Identifier: BSD-3-Clause
#include "worker_keeper.h"
#include "worker_process.h"

#include <slalom/core/error.h>
#include <slalom/core/fork.h>
#include <slalom/core/text.h>
#include <slalom/workers/worker_sandbox.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace slalom {
namespace {

/// Larger than any valid payload; a larger size means corrupted data.
constexpr std::uint64_t kMaxPayload = std::uint64_t{1} << 30;

constexpr char kKeeperKilled[] = "its supervising process was stopped or killed";

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

void ReadChannel::clear() {
  read_output();
  printed_.clear();
  printed_last_.clear();
  left_out_ = 0;
  log->clear();
}

void ReadChannel::read_output() {
  constexpr std::size_t kHalf = kMaxOutput / 2;
  constexpr int kMaxReads = 32;  // of a method that never ends to print
  char chunk[65536];
  for (int i = 0; i < kMaxReads && output; ++i) {
    const ssize_t got = ::read(output.number(), chunk, sizeof chunk);
    if (got <= 0) return;
    const auto size = static_cast<std::size_t>(got);
    const std::size_t first = std::min(size, kHalf - printed_.size());
    printed_.append(chunk, first);
    printed_last_.append(chunk + first, size - first);
    if (printed_last_.size() <= kHalf) continue;
    left_out_ += printed_last_.size() - kHalf;
    printed_last_.erase(0, printed_last_.size() - kHalf);
  }
}

std::string ReadChannel::take_output() {
  read_output();
  const std::string gap =
      left_out_ == 0 ? "" : "\n... " + std::to_string(left_out_) + " bytes left out ...\n";
  return printed_ + gap + printed_last_;
}

void WorkerProcess::start(std::size_t group) {
  SocketPair work, control;
  WorkerStart start;
  start.socket = std::move(work.far_end);
  start.control = std::move(control.far_end);
  if (keeper_ != nullptr)
    start_kept(start);
  else
    fork_trusted(start);
  socket_ = std::move(work.near_end);
  control_ = std::move(control.near_end);
  fcntl(socket_.number(), F_SETFL, O_NONBLOCK);
  disconnected_ = has_died_ = false;
  group_ = group;
  assigned_ = 0;
  next_.reset();
  died_between_items_ = false;
  buffer_.clear();
}

void WorkerProcess::start_kept(WorkerStart& start) {
  for (const int i : {0, 1}) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) throw cannot_create("pipe", errno);
    channels_[i].output = FileDescriptor(ends[0]);
    start.outputs[i] = FileDescriptor(ends[1]);
    fcntl(ends[1], F_SETFL, 0);             // methods do not expect that they cannot print
    fcntl(ends[1], F_SETPIPE_SZ, 1 << 19);  // nor to wait for it; the system may not allow it
    start.logs[i] = FileDescriptor(SharedTaskLog::make_file(options_.log_size));
    if (!start.logs[i]) throw cannot_create("log", errno);
    channels_[i].log = std::make_unique<SharedTaskLog>(options_.log_size, start.logs[i].number());
  }
  if (options_.limits.sandbox) start.scratch = make_scratch_folder();
  if (options_.limits.sandbox && start.scratch.empty())
    throw cannot_create("folder for temporary files", errno);
  keeper_->start_worker(start);
  generation_ = keeper_->generation();
}

void WorkerProcess::fork_trusted(const WorkerStart& start) {
  for (ReadChannel& channel : channels_)
    channel.log = std::make_unique<SharedTaskLog>(options_.log_size);
  child_ = fork_process();
  if (child_ < 0) throw cannot_create("process", errno);
  if (child_ > 0) return;
  drop_descriptors(options_.keep_stderr, {start.socket.number(), start.control.number()});
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  serve_work_items(start.socket.number(), *trusted_item_, options_, receive_file_,
                   {{std::move(channels_[0].log)}, {std::move(channels_[1].log)}});
  _exit(0);
}

bool WorkerProcess::is_sound() const {
  const bool is_kept = keeper_ == nullptr || generation_ == keeper_->generation();
  pollfd events[] = {{socket_.number(), POLLIN, 0}, {control_.number(), POLLIN, 0}};
  return is_kept && poll(events, 2, 0) == 0;
}

void WorkerProcess::assign(std::size_t index, int file) {
  begin_item(send(index, file));
}

bool WorkerProcess::wants_next() const {
  constexpr double kShort = 0.05;  // s, many times what the parent needs for an answer
  return busy_ && !ending_ && !next_ && assigned_ > 1 && duration_ < kShort;
}

void WorkerProcess::assign_next(std::size_t index, int file) {
  next_ = send(index, file);
}

std::optional<std::size_t> WorkerProcess::take_unstarted() {
  const std::optional<Request> request = std::exchange(next_, std::nullopt);
  return request ? std::optional(std::size_t{request->index}) : std::nullopt;
}

/// Sends the request for the work item after the current one.
Request WorkerProcess::send(std::size_t index, int file) {
  channels_[(assigned_ + 1) % 2].clear();
  const Request request = {std::uint64_t{random_()} << 32U | random_(), index};
  // The death of a worker is detected by the next receive().
  send_request(socket_.number(), request, file);
  return request;
}

void WorkerProcess::begin_item(const Request& request) {
  current_ = request;
  ++assigned_;
  heartbeats_ = 0;
  busy_ = true;
  started_ = last_heartbeat_ = options_.hooks.clock();
}

void WorkerProcess::add_events(std::vector<pollfd>& events) const {
  if (!busy()) return;
  if (socket_ && !disconnected_) events.push_back({socket_.number(), POLLIN, 0});
  events.push_back({control_.number(), POLLIN, 0});
}

void WorkerProcess::read() {
  if (ending_) return;
  read_socket();
  if (has_answer()) return;
  has_died_ = is_readable(control_.number(), 0);
  if (has_died_) read_socket();  // a process may answer and then die
}

bool WorkerProcess::has_answer() const {
  AnswerHeader header = {};
  if (buffer_.size() < sizeof header) return false;
  std::memcpy(&header, buffer_.data(), sizeof header);
  return header.size > kMaxPayload || buffer_.size() - sizeof header >= header.size;
}

std::optional<WorkResult> WorkerProcess::receive(bool keeper_is_alive) {
  if (ending_) return take_ended();
  if (auto result = take_answer(keeper_is_alive)) return result;
  if (has_died_) return describe_end();
  const std::string limit = exceeded_limit();
  if (limit.empty()) return std::nullopt;
  return kill_with(Status::TimedOut, limit);
}

void WorkerProcess::read_socket() {
  char chunk[65536];
  while (!disconnected_ && !has_answer()) {
    const ssize_t got = recv(socket_.number(), chunk, sizeof chunk, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    disconnected_ = got <= 0;
    if (got > 0) buffer_.append(chunk, static_cast<std::size_t>(got));
  }
}

std::optional<WorkResult> WorkerProcess::take_answer(bool keeper_is_alive) {
  AnswerHeader header = {};
  if (buffer_.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, buffer_.data(), sizeof header);
  const bool is_known =
      header.kind == kDone || header.kind == kThrew || header.kind == kOutOfMemory;
  if (!is_known || header.size > kMaxPayload)
    return kill_with(Status::Crashed, "wrote invalid data to the worker's socket");
  if (header.request.nonce != current_.nonce || header.request.index != current_.index)
    return kill_with(Status::Crashed, "sent an unsolicited reply");
  if (buffer_.size() < sizeof header + header.size) return std::nullopt;
  // A method may have killed the keeper and answered before it died with it.
  if (keeper_ != nullptr && (generation_ != keeper_->generation() || !keeper_is_alive))
    return kill_with(Status::Killed, kKeeperKilled);
  std::string payload = buffer_.substr(sizeof header, header.size);
  if (header.kind == kThrew) return kill_with(Status::Threw, std::move(payload));
  if (header.kind == kOutOfMemory) return kill_with(Status::OutOfMemory, std::move(payload));
  if (options_.hooks.is_valid && !options_.hooks.is_valid(current_.index, payload))
    return kill_with(Status::Crashed, kInvalidPayload);
  buffer_.erase(0, sizeof header + header.size);
  busy_ = false;
  duration_ = options_.hooks.clock() - started_;
  WorkResult result{Status::Done, std::move(payload), "", "", channel().take_output()};
  if (channel().log->is_retired() || !is_begin_of_next_answer(buffer_) || disconnected_)
    begin_end();
  else if (next_)
    begin_item(*std::exchange(next_, std::nullopt));
  return result;
}

/// Whether these bytes are what a process may have sent after an answer.
bool WorkerProcess::is_begin_of_next_answer(const std::string& bytes) const {
  return bytes.empty() ||
         (next_ && std::memcmp(bytes.data(), &*next_, std::min(bytes.size(), sizeof *next_)) == 0);
}

std::string WorkerProcess::exceeded_limit() {
  // The clock is read first: a heartbeat in between must not count as missing.
  const double now = options_.hooks.clock();
  const std::uint64_t heartbeats = channel().log->heartbeats();
  if (heartbeats != heartbeats_) {
    heartbeats_ = heartbeats;
    last_heartbeat_ = now;
  }
  if (options_.limits.heartbeat_timeout > 0 && heartbeats_ > 0 &&
      now - last_heartbeat_ > options_.limits.heartbeat_timeout)
    return "no response within " + format_number(options_.limits.heartbeat_timeout) + " s";
  if (options_.limits.item_wall_time > 0 && now - started_ > options_.limits.item_wall_time)
    return "run_wall_time = " + format_number(options_.limits.item_wall_time) +
           " s exceeded, a wall-clock limit on this machine";
  return "";
}

std::optional<WorkResult> WorkerProcess::kill_with(Status status, std::string reason) {
  result_ = WorkResult{status, "", std::move(reason), ""};
  begin_end();
  return take_ended();
}

std::optional<WorkResult> WorkerProcess::take_ended() {
  if (ending_ && !is_readable(control_.number(), 0)) return std::nullopt;
  ending_ = busy_ = false;
  control_ = FileDescriptor();
  if (result_) result_->log = channel().log->contents();
  if (result_) result_->output = channel().take_output();
  return std::exchange(result_, std::nullopt);
}

std::optional<int> WorkerProcess::end_status() {
  int status = 0;
  if (recv(control_.number(), &status, sizeof status, 0) == sizeof status) return status;
  if (keeper_ != nullptr) return std::nullopt;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) continue;
  child_ = -1;
  return status;
}

std::optional<WorkResult> WorkerProcess::describe_end() {
  const std::optional<int> ended = end_status();
  if (!ended) return kill_with(Status::Killed, kKeeperKilled);
  const int status = *ended;
  died_between_items_ = assigned_ > 1 && channel().log->heartbeats() == 0;
  if (status == kNoWorker) throw cannot_create("process", EAGAIN);
  if (was_killed_by(status, SIGXCPU))
    return kill_with(
        Status::TimedOut,
        "CPU time limit of " + format_number(options_.limits.item_cpu_time) + " s exceeded");
  if (was_killed_by(status, SIGKILL)) return kill_with(Status::Killed, describe_status(status));
  if (channel().log->is_disconnected())
    return kill_with(Status::Crashed, "closed the worker's connection to the simulator");
  return kill_with(Status::Crashed, describe_status(status));
}

void WorkerProcess::begin_end() {
  if (!socket_) return;
  socket_ = FileDescriptor();
  buffer_.clear();
  ending_ = keeper_ != nullptr;
  if (ending_) shutdown(control_.number(), SHUT_WR);
  if (child_ > 0) kill(child_, SIGKILL);
  while (child_ > 0 && waitpid(child_, nullptr, 0) < 0 && errno == EINTR) continue;
  child_ = -1;
}

void WorkerProcess::request_end() {
  if (idle()) shutdown(socket_.number(), SHUT_WR);
}

void WorkerProcess::await_end() {
  if (idle()) is_readable(control_.number(), static_cast<int>(kShutdownTimeout * 1000));
  begin_end();
}

}  // namespace slalom
