// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/program_path.h>
#include <slalom/methods/external_process.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

extern char** environ;

namespace slalom {
namespace {

constexpr int kTerminationTimeout = 300;  // ms from SIGTERM to SIGKILL
constexpr int kCannotExecute = 127;       // exit status, as in shells

/// Returns "NAME=VALUE" of this process's environment and of the added variables, which take
/// precedence.
std::vector<std::string> merged_environment(EnvironmentVariables added) {
  const char* path = std::getenv("PATH");
  added.emplace_back("PATH", program_folder() + (path == nullptr ? "" : ":" + std::string(path)));
  std::vector<std::string> all;
  for (const auto& [name, value] : added) all.push_back(name + "=" + value);
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    const std::string name = text.substr(0, text.find('='));
    bool replaced = false;
    for (const auto& a : added) replaced = replaced || a.first == name;
    if (!replaced) all.push_back(text);
  }
  return all;
}

/// A worker limits its own CPU time per run, but this process serves many runs.
void lift_time_limit() {
  rlimit limit{};
  getrlimit(RLIMIT_CPU, &limit);
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_CPU, &limit);
}

/// Runs in the child after fork(). Other threads may have held locks: only system calls are safe.
[[noreturn]] void exec_child(char* const* arguments, char* const* environment, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kCannotExecute);  // the parent died before prctl()
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
  lift_time_limit();
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int null_device = open("/dev/null", O_RDWR);
  dup2(null_device, STDIN_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);  // programs print their results on standard output
  syscall(SYS_close_range, STDERR_FILENO + 1, ~0U, 0);
  execve("/bin/sh", arguments, environment);
  _exit(kCannotExecute);
}

/// Checks for the exit without reaping, so that the process (group) id is not reused.
bool poll_exit(pid_t pid, siginfo_t& info) {
  info = {};
  const int flags = WEXITED | WNOHANG | WNOWAIT;
  return waitid(P_PID, static_cast<id_t>(pid), &info, flags) == 0 && info.si_pid == pid;
}

}  // namespace

ExternalProcess::ExternalProcess(const std::string& command_line,
                                 const EnvironmentVariables& added) {
  std::vector<std::string> variables = merged_environment(added);
  std::vector<char*> environment;
  for (std::string& variable : variables) environment.push_back(variable.data());
  environment.push_back(nullptr);
  std::string shell = "sh", option = "-c", command = command_line;
  char* const arguments[] = {shell.data(), option.data(), command.data(), nullptr};
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "cannot create a process");
  if (pid_ == 0) exec_child(arguments, environment.data(), parent);
  setpgid(pid_, pid_);  // in parent and child, to avoid a race
}

ExternalProcess::~ExternalProcess() {
  kill(-pid_, SIGTERM);
  siginfo_t info;
  for (int i = 0; i < kTerminationTimeout && !poll_exit(pid_, info); ++i) usleep(1000);
  kill(-pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
}

std::optional<std::string> ExternalProcess::exit_description() const {
  siginfo_t info;
  if (!poll_exit(pid_, info)) return std::nullopt;
  if (info.si_code == CLD_EXITED) return "exit status " + std::to_string(info.si_status);
  return "signal " + std::to_string(info.si_status) + " (" + strsignal(info.si_status) + ")";
}

}  // namespace slalom
