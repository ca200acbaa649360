// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/child_process.h>
#include <slalom/core/error.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace slalom {
namespace {

constexpr int kPollInterval = 100;          // ms
constexpr int kTerminationIntervals = 100;  // of kPollInterval, from SIGINT to SIGKILL
constexpr char kNullDevice[] = "/dev/null";

/// Options of posix_spawn() for the new process: its streams, and signals as in a new shell.
class SpawnOptions {
 public:
  explicit SpawnOptions(int output) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, kNullDevice, O_RDONLY, 0);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_adddup2(&actions, output, stream);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes, &signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaddset(&signals, signal);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnOptions() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnOptions(const SpawnOptions&) = delete;
  SpawnOptions& operator=(const SpawnOptions&) = delete;

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

class ChildProcess {
 public:
  explicit ChildProcess(std::vector<std::string> command) {
    std::vector<char*> arguments;
    for (std::string& argument : command) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    std::array<int, 2> ends{};
    int error = pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno;
    if (error == 0) {
      const SpawnOptions options(ends[1]);
      error = posix_spawnp(&pid_, arguments[0], &options.actions, &options.attributes,
                           arguments.data(), environ);
      close(ends[1]);
      if (error != 0) close(ends[0]);
    }
    if (error != 0)
      throw job_error(command[0], "cannot be started: " + std::string(strerror(error)));
    output_ = ends[0];
    fcntl(output_, F_SETFL, O_NONBLOCK);
  }
  ~ChildProcess() {
    if (!has_ended()) kill(pid_, SIGINT);
    // Its output is read, since it might wait for that.
    for (int i = 0; i < kTerminationIntervals && !has_ended(); ++i) wait_for_output();
    if (!has_ended()) {
      kill(pid_, SIGKILL);
      while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
    }
    close(output_);
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool has_ended() {
    int status = 0;
    if (status_ < 0 && waitpid(pid_, &status, WNOHANG) == pid_)
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return status_ >= 0;
  }
  int status() const { return status_; }
  /// Reads what is there; waits for it at most kPollInterval.
  void wait_for_output() {
    pollfd output{is_open_ ? output_ : -1, POLLIN, 0};
    poll(&output, 1, kPollInterval);
    read_output();
  }
  void read_output() {
    std::array<char, 4096> bytes{};
    ssize_t size = 0;
    while ((size = read(output_, bytes.data(), bytes.size())) > 0)
      text_.append(bytes.data(), static_cast<std::size_t>(size));
    is_open_ = size < 0;  // nothing to read now
  }
  /// Takes the next complete line, or with `all` also an incomplete one; false if there is none.
  bool take_line(std::string& line, bool all) {
    const std::size_t end = text_.find('\n');
    if (end == std::string::npos && (!all || text_.empty())) return false;
    line = text_.substr(0, end);
    text_.erase(0, end == std::string::npos ? end : end + 1);
    return true;
  }

 private:
  pid_t pid_ = -1;
  int output_ = -1, status_ = -1;
  bool is_open_ = true;
  std::string text_;  ///< read, but not taken
};

}  // namespace

int execute_program(const std::vector<std::string>& command,
                    const std::function<void(const std::string& line)>& on_line,
                    const std::function<void()>& wait) {
  ChildProcess child(command);
  std::string line;
  while (!child.has_ended()) {
    child.wait_for_output();
    while (child.take_line(line, false)) on_line(line);
    wait();
  }
  child.read_output();  // what it wrote before it ended
  while (child.take_line(line, true)) on_line(line);
  return child.status();
}

}  // namespace slalom
