// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

using EnvironmentVariables = std::vector<std::pair<std::string, std::string>>;

/// A process started from a shell command line, in its own process group, without input and with
/// its output discarded. The folder of the running program is on its PATH. It is killed when its
/// parent process dies. There is one implementation file per operating system.
class ExternalProcess {
 public:
  /// Throws std::system_error when the process cannot be created.
  ExternalProcess(const std::string& command_line, const EnvironmentVariables& variables);
  /// Terminates the process group: SIGTERM, then SIGKILL after a timeout.
  ~ExternalProcess();
  ExternalProcess(const ExternalProcess&) = delete;
  ExternalProcess& operator=(const ExternalProcess&) = delete;

  /// Returns how it ended ("exit status 3", "signal 9 (Killed)"), or nothing while it is running.
  std::optional<std::string> exit_description() const;

 private:
  int pid_ = -1;
};

}  // namespace slalom
