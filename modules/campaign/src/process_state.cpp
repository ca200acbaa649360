#include "process_state.h"

#include <slalom/core/orphans.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

extern char** environ;

namespace slalom {
namespace {

std::vector<std::string> environment() {
  std::vector<std::string> variables;
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable)
    variables.emplace_back(*variable);
  return variables;
}

std::string current_folder() {
  std::error_code error;
  return std::filesystem::current_path(error).string();
}

mode_t current_umask() {
  const mode_t mode = umask(077);
  umask(mode);
  return mode;
}

std::size_t count_threads() {
  struct stat threads = {};
  return stat("/proc/self/task", &threads) == 0 ? threads.st_nlink : 0;  // one folder per thread
}

/// A timer would end the next run with its signal.
void stop_timers() {
  const itimerval never = {};
  for (const auto timer : {ITIMER_REAL, ITIMER_VIRTUAL, ITIMER_PROF})
    setitimer(timer, &never, nullptr);
}

}  // namespace

ProcessState::ProcessState()
    : c_locale_(setlocale(LC_ALL, nullptr)),
      thread_locale_(uselocale(nullptr)),
      folder_(current_folder()),
      umask_(current_umask()),
      environment_(environment()),
      threads_(count_threads()),
      children_(child_processes()) {
  for (int signal = 1; signal < NSIG; ++signal)
    sigaction(signal, nullptr, &actions_[static_cast<std::size_t>(signal)]);
  sigprocmask(SIG_SETMASK, nullptr, &blocked_);
  for (std::size_t resource = 0; resource < limits_.size(); ++resource)
    getrlimit(static_cast<__rlimit_resource_t>(resource), &limits_[resource]);
}

bool ProcessState::restore() const {
  stop_timers();
  restore_signals();
  restore_locale();
  restore_environment();
  umask(umask_);
  const bool in_folder = current_folder() == folder_ || chdir(folder_.c_str()) == 0;
  const bool limited = restore_limits();
  const std::vector<pid_t> left = child_processes();
  return in_folder && limited && count_threads() <= threads_ &&
         std::all_of(left.begin(), left.end(), [this](pid_t pid) {
           return std::find(children_.begin(), children_.end(), pid) != children_.end();
         });
}

void ProcessState::restore_signals() const {
  for (int signal = 1; signal < NSIG; ++signal) {
    const struct sigaction& action = actions_[static_cast<std::size_t>(signal)];
    struct sigaction now = {};
    if (sigaction(signal, nullptr, &now) == 0 &&
        (now.sa_handler != action.sa_handler || now.sa_flags != action.sa_flags))
      sigaction(signal, &action, nullptr);
  }
  sigprocmask(SIG_SETMASK, &blocked_, nullptr);
}

void ProcessState::restore_locale() const {
  if (std::locale() != cpp_locale_) std::locale::global(cpp_locale_);
  if (c_locale_ != setlocale(LC_ALL, nullptr)) setlocale(LC_ALL, c_locale_.c_str());
  uselocale(thread_locale_);
}

bool ProcessState::restore_limits() const {
  bool restored = true;
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const auto resource = static_cast<__rlimit_resource_t>(i);
    rlimit now = {};
    if (getrlimit(resource, &now) == 0 &&
        (now.rlim_cur != limits_[i].rlim_cur || now.rlim_max != limits_[i].rlim_max))
      restored = setrlimit(resource, &limits_[i]) == 0 && restored;
  }
  return restored;
}

void ProcessState::restore_environment() const {
  if (environment() == environment_) return;
  clearenv();
  for (const std::string& variable : environment_) {
    const std::size_t end = variable.find('=');
    if (end != std::string::npos)
      setenv(variable.substr(0, end).c_str(), variable.substr(end + 1).c_str(), 1);
  }
}

}  // namespace slalom
