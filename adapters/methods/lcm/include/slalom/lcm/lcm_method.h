// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/core/wall_clock.h>
#include <slalom/methods/method_factory.h>

#include <map>
#include <string>

namespace slalom {

/// Simulated time waits for replies, or follows the wall clock.
enum class LcmMode { Lockstep, Realtime };
constexpr auto enum_names(LcmMode) {
  return std::array{"lockstep", "realtime"};
}

/// LCM's default multicast group, within this machine.
inline constexpr char kLcmUrl[] = "udpm://239.255.76.67:7667?ttl=0";

/// A method of the adapter lcm.
struct LcmOptions {
  std::string url;  ///< empty: kLcmUrl, for a launched process with a port of its own
  std::string channel = "SLALOM";  ///< prefix of the channel names
  std::string launch;              ///< command line of the external process; empty: already running
  double deadline = 2;             ///< wall-clock time for a reply, s
  double startup_time = 10;        ///< wall-clock time for a process to start and reply, s
  LcmMode mode = LcmMode::Lockstep;

  std::string name = "method";  ///< sent to the process; in an .ini the name of the method
  std::string folder = ".";     ///< its SLALOM_INI_FOLDER; in an .ini the folder of the file
  /// Settings of the external method; in an .ini all other keys of the section.
  std::map<std::string, std::string> settings = {};

  void visit(OptionVisitor& v);  ///< without name, folder and settings
};

/// A method in another process, reached over LCM with the messages of lcm_types/.
///
/// Lock-step: step() waits for the command with its run id and sequence number; all other messages
/// are ignored. Real time: step() waits for the end of its control period on the wall clock and
/// returns the latest command received (zero velocity before the first one).
///
/// With `launch` the process is started at once, on unique channels (without `url` also on a UDP
/// port of its own: a process that does not run for some milliseconds loses its messages to those
/// of others that fill its buffer), monitored, restarted after a run that it failed, and terminated
/// together with the method. step() and reset() throw MethodTimeout when no reply arrives before
/// the deadline, and MethodError when the process exits or reports an error. The factory throws
/// Error (Usage) when LCM is not available, or when the launched process exits, reports an error or
/// does not reply within the startup time. `clock` is used for deadlines and real time.
MethodFactory lcm_method(const LcmOptions& options, const WallClock& clock = steady_seconds);

/// The same with options from an .ini; a MethodReader.
MethodFactory read_lcm_method(const IniFile& ini, const std::string& section,
                              const WallClock& clock = steady_seconds);

}  // namespace slalom
