#include "external_process.h"

#include <cerrno>
#include <climits>
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

constexpr int kPatience = 300;       // ms from the request to end to the kill
constexpr int kCannotExecute = 127;  // exit status, as shells have it

std::string own_folder() {
  char buffer[PATH_MAX];
  const ssize_t size = readlink("/proc/self/exe", buffer, sizeof buffer);
  const std::string path(buffer, size > 0 ? static_cast<std::size_t>(size) : 0);
  return path.substr(0, path.find_last_of('/'));
}

/// "NAME=VALUE" of this process's environment, with those added.
std::vector<std::string> environment_with(EnvironmentVariables added) {
  const char* path = std::getenv("PATH");
  added.emplace_back("PATH", own_folder() + (path == nullptr ? "" : ":" + std::string(path)));
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

/// A worker limits its own time for each run; the process lives for many runs.
void lift_time_limit() {
  rlimit limit{};
  getrlimit(RLIMIT_CPU, &limit);
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_CPU, &limit);
}

/// In the new process. Other threads' locks may be held for ever: system calls only.
[[noreturn]] void become(char* const* arguments, char* const* environment, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kCannotExecute);  // it died before we asked to die with it
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
  lift_time_limit();
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int null_device = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(null_device, stream);
  syscall(SYS_close_range, STDERR_FILENO + 1, ~0U, 0);
  execve("/bin/sh", arguments, environment);
  _exit(kCannotExecute);
}

/// Looks without reaping: the number of the process, and so of its group, stays taken.
bool look(pid_t pid, siginfo_t& info) {
  info = {};
  const int flags = WEXITED | WNOHANG | WNOWAIT;
  return waitid(P_PID, static_cast<id_t>(pid), &info, flags) == 0 && info.si_pid == pid;
}

}  // namespace

ExternalProcess::ExternalProcess(const std::string& command_line,
                                 const EnvironmentVariables& added) {
  std::vector<std::string> variables = environment_with(added);
  std::vector<char*> environment;
  for (std::string& variable : variables) environment.push_back(variable.data());
  environment.push_back(nullptr);
  std::string shell = "sh", option = "-c", command = command_line;
  char* const arguments[] = {shell.data(), option.data(), command.data(), nullptr};
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "no process can be made");
  if (pid_ == 0) become(arguments, environment.data(), parent);
  setpgid(pid_, pid_);  // whoever is first: both ask
}

ExternalProcess::~ExternalProcess() {
  kill(-pid_, SIGTERM);
  siginfo_t info;
  for (int i = 0; i < kPatience && !look(pid_, info); ++i) usleep(1000);
  kill(-pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
}

std::optional<std::string> ExternalProcess::ended() const {
  siginfo_t info;
  if (!look(pid_, info)) return std::nullopt;
  if (info.si_code == CLD_EXITED) return "exit status " + std::to_string(info.si_status);
  return "signal " + std::to_string(info.si_status) + " (" + strsignal(info.si_status) + ")";
}

}  // namespace slalom
