// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/orphans.h>
#include <slalom/core/text.h>
#include <slalom/workers/process_state.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sched.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
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

/// Whether a line of /proc/self/status states what a process can change of itself.
bool is_attribute(const std::string& line) {
  static const std::vector<std::string> kAttributes = {
      "Uid:",     "Gid:",        "Groups:",      "VmLck:",        "VmPin:",        "Cap",
      "Seccomp:", "NoNewPrivs:", "THP_enabled:", "Cpus_allowed:", "Mems_allowed:", "Speculation"};
  return std::any_of(kAttributes.begin(), kAttributes.end(),
                     [&](const std::string& name) { return starts_with(line, name); });
}

/// Scheduling, rights, locked memory and the like. They are compared only: what changes them is
/// rare, and not all can be restored.
std::vector<std::string> attributes() {
  std::vector<std::string> values;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (is_attribute(line)) values.push_back(line);
  sched_param priority = {};
  sched_getparam(0, &priority);
  int death_signal = 0, subreaper = 0;
  prctl(PR_GET_PDEATHSIG, &death_signal);
  prctl(PR_GET_CHILD_SUBREAPER, &subreaper);
  constexpr int kOfProcess = 1;  // IOPRIO_WHO_PROCESS
  constexpr unsigned long kQuery = 0xffffffff;
  for (const long value :
       {long{sched_getscheduler(0)}, long{priority.sched_priority},
        long{getpriority(PRIO_PROCESS, 0)}, syscall(SYS_ioprio_get, kOfProcess, 0),
        long{personality(kQuery)}, long{death_signal}, long{subreaper}, long{getpgrp()},
        long{prctl(PR_GET_DUMPABLE)}, long{prctl(PR_GET_TIMERSLACK)}, long{prctl(PR_GET_TSC)}})
    values.push_back(std::to_string(value));
  return values;
}

/// The kernel's number of the next timer of timer_create(), which counts those that were created;
/// -1 if there can be none.
long next_timer() {
  sigevent silent = {};
  silent.sigev_notify = SIGEV_NONE;
  int timer = -1;  // not timer_t: the C library numbers timers itself
  if (syscall(SYS_timer_create, CLOCK_MONOTONIC, &silent, &timer) != 0) return -1;
  syscall(SYS_timer_delete, timer);
  return long{timer} + 1;
}

/// A timer would end the next run with its signal.
void stop_timers() {
  const itimerval never = {};
  for (const auto timer : {ITIMER_REAL, ITIMER_VIRTUAL, ITIMER_PROF})
    setitimer(timer, &never, nullptr);
}

__rlimit_resource_t resource(std::size_t i) {
  return static_cast<__rlimit_resource_t>(i);
}

/// Names by the number of the resource.
constexpr const char* kNamesOfLimits[] = {
    "CPU",     "FSIZE", "DATA",  "STACK",      "CORE",     "RSS",  "NPROC",  "NOFILE",
    "MEMLOCK", "AS",    "LOCKS", "SIGPENDING", "MSGQUEUE", "NICE", "RTPRIO", "RTTIME"};
static_assert(std::size(kNamesOfLimits) == RLIMIT_NLIMITS);
static_assert(RLIMIT_CPU == 0 && RLIMIT_NOFILE == 7 && RLIMIT_AS == 9 && RLIMIT_RTPRIO == 14);

}  // namespace

ResourceLimits::ResourceLimits() {
  for (std::size_t i = 0; i < limits_.size(); ++i) getrlimit(resource(i), &limits_[i]);
}

bool ResourceLimits::restore() const {
  bool restored = true;
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    rlimit now = {};
    if (getrlimit(resource(i), &now) == 0 &&
        (now.rlim_cur != limits_[i].rlim_cur || now.rlim_max != limits_[i].rlim_max))
      restored = setrlimit(resource(i), &limits_[i]) == 0 && restored;
  }
  return restored;
}

std::string ResourceLimits::restore_lowered() const {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    rlimit now = {};
    getrlimit(resource(i), &now);
    const bool is_lower = now.rlim_cur < limits_[i].rlim_cur || now.rlim_max < limits_[i].rlim_max;
    if (is_lower && setrlimit(resource(i), &limits_[i]) != 0)
      return std::string("RLIMIT_") + kNamesOfLimits[i];
  }
  return "";
}

ProcessState::ProcessState()
    : c_locale_(setlocale(LC_ALL, nullptr)),
      thread_locale_(uselocale(nullptr)),
      folder_(current_folder()),
      umask_(current_umask()),
      environment_(environment()),
      attributes_(attributes()),
      next_timer_(next_timer()),
      threads_(count_threads()),
      children_(child_processes()) {
  for (int signal = 1; signal < NSIG; ++signal)
    sigaction(signal, nullptr, &actions_[static_cast<std::size_t>(signal)]);
  sigprocmask(SIG_SETMASK, nullptr, &blocked_);
}

bool ProcessState::restore() const {
  stop_timers();
  restore_signals();
  restore_locale();
  restore_environment();
  umask(umask_);
  const bool in_folder = current_folder() == folder_ || chdir(folder_.c_str()) == 0;
  const bool limited = limits_.restore();
  const bool has_no_timer = next_timer_ >= 0 && next_timer() == next_timer_ + 1;
  const std::vector<pid_t> left = child_processes();
  return in_folder && limited && has_no_timer && attributes() == attributes_ &&
         count_threads() <= threads_ && std::all_of(left.begin(), left.end(), [this](pid_t pid) {
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
