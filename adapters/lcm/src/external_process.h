#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

using EnvironmentVariables = std::vector<std::pair<std::string, std::string>>;

/// A process started by a shell's command line, in a process group of its own, without input and
/// with its output discarded. The programs' own folder is on its PATH. It dies with the process
/// that started it. One file per operating system implements it.
class ExternalProcess {
 public:
  /// Throws std::system_error when no process can be made.
  ExternalProcess(const std::string& command_line, const EnvironmentVariables& added);
  /// Ends the whole group: asks, and kills what has not ended a moment later.
  ~ExternalProcess();
  ExternalProcess(const ExternalProcess&) = delete;
  ExternalProcess& operator=(const ExternalProcess&) = delete;

  /// How it ended ("exit status 3", "signal 9 (Killed)"), or nothing while it runs.
  std::optional<std::string> ended() const;

 private:
  int pid_ = -1;
};

}  // namespace slalom
