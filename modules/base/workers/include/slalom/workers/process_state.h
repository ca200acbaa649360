// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <clocale>
#include <csignal>
#include <locale>
#include <string>
#include <sys/resource.h>
#include <sys/types.h>
#include <vector>

namespace slalom {

/// The limits of a process (getrlimit) when this was constructed.
class ResourceLimits {
 public:
  ResourceLimits();
  /// Restores all; false if one cannot be raised again.
  bool restore() const;
  /// Restores those that were lowered. Returns the name of one that cannot be raised again, such as
  /// "RLIMIT_NOFILE"; "" if there is none.
  std::string restore_lowered() const;

 private:
  std::array<rlimit, RLIMIT_NLIMITS> limits_ = {};  ///< by resource
};

/// Everything that a method can change in its process and that affects its next run: signal
/// handlers and mask, timers, locale, current folder, umask, resource limits, environment
/// variables, scheduling and other attributes of the process, threads and child processes. (The
/// floating-point environment is not in it: the simulation restores it.)
class ProcessState {
 public:
  ProcessState();  ///< the current state

  /// Restores the state. Returns false if this is not possible, if attributes have changed, or if
  /// there are threads or child processes that did not exist: the process is to be replaced.
  bool restore() const;

 private:
  void restore_signals() const;
  void restore_locale() const;
  void restore_environment() const;

  std::array<struct sigaction, NSIG> actions_ = {};  ///< by signal
  sigset_t blocked_;
  std::string c_locale_;
  locale_t thread_locale_;
  std::locale cpp_locale_;
  std::string folder_;
  mode_t umask_;
  ResourceLimits limits_;
  std::vector<std::string> environment_;
  std::vector<std::string> attributes_;
  long next_timer_;
  std::size_t threads_;
  std::vector<pid_t> children_;
};

}  // namespace slalom
