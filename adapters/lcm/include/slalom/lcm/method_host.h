#pragma once

#include <slalom/lcm/protocol.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The method's end of the protocol, without the network: what a process answers that hosts a
/// Method. Observations out of turn are not answered.
class MethodHost {
 public:
  /// Builds the method that a hello asks for; what it throws refuses.
  using Factory = std::function<std::unique_ptr<Method>(const hello_t&)>;

  MethodHost(std::string name, Factory factory);

  /// Builds the method, once per number of a hello. Throws MethodError for another version.
  ready_t greet(const hello_t& hello);
  /// Throws what the method throws, MethodError where nobody said hello.
  ready_t start(const run_start_t& message);
  /// Throws what the method throws.
  std::optional<command_t> answer(const observation_t& message);

 private:
  ready_t ready(std::int64_t id) const;

  std::string name_;
  Factory factory_;
  SensorModel sensor_;
  std::unique_ptr<Method> method_;
  std::int64_t hello_id_ = 0, run_id_ = 0, next_sequence_ = -1;
  ReceivedScan scan_;
};

/// Serves a simulator over LCM until `stop` (asked every tenth of a second) says so. Exceptions are
/// sent as error_t. Throws Error (Job) when LCM cannot be used.
void serve_method(MethodHost& host, const std::string& url, const std::string& channel,
                  const std::function<bool()>& stop);

/// What came of comparing a method with a log.
struct LogReplay {
  std::size_t runs = 0, observations = 0, commands = 0;
  std::size_t different = 0;     ///< commands that are not the logged ones, bit by bit
  std::string first_difference;  ///< for people
};

/// Gives the observations of a log (of lcm-logger) to a method again and compares what it answers
/// with the logged commands. Methods on several channels are kept apart; `make_host` makes a host
/// for each. Throws Error (File) for a log that cannot be read or has no observations.
LogReplay replay_log(const std::string& path, const std::function<MethodHost()>& make_host);

}  // namespace slalom
