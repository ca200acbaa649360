#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method.h>

#include <map>
#include <memory>
#include <string>

namespace slalom {

/// Section [method.NAME] with adapter = lcm; further keys are settings of the external method.
struct LcmOptions {
  std::string url = "udpm://239.255.76.67:7667?ttl=0";
  std::string channel = "SLALOM";  ///< first part of the channels' names
  std::string launch;              ///< command line of the external process; empty: it runs already
  double deadline = 2;             ///< s of wall-clock time for an answer
  double startup_time = 10;        ///< s of wall-clock time for a process to start and answer
  std::string mode = "lockstep";   ///< or realtime

  void visit(OptionVisitor& v);
  bool realtime() const { return mode == "realtime"; }
};

/// Reads the options of a section, all keys but these being the method's own. Throws Error (Usage).
LcmOptions read_lcm_options(const IniFile& ini, const std::string& section);

/// The keys of a section that are not among LcmOptions, with their values.
std::map<std::string, std::string> own_settings(const IniFile& ini, const std::string& section);

/// A method in another process, reached over LCM with the messages of lcm_types/.
///
/// Lock-step: step() waits for the command with its run and sequence number; whatever else comes is
/// ignored. Real time: step() waits for its control period on the wall clock and answers the newest
/// command that has come (none yet: stands still).
///
/// With `launch` the process is started at once, on channels of its own, watched, started again for
/// the run after one that it spoilt, and ended with the method. step() and reset() throw
/// MethodTimeout for silence beyond the deadline and MethodError when the process ended or says so.
/// Throws Error (Usage) when LCM cannot be used, or the launched process ends, refuses or does not
/// answer within its startup time.
std::unique_ptr<Method> make_lcm_method(const MethodContext& context);

}  // namespace slalom
