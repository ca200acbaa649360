// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/lcm/protocol.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The method's side of the protocol, without the network: the replies of a process that hosts a
/// Method. Observations that are out of sequence get no reply.
class MethodHost {
 public:
  /// Creates the method requested by a hello; an exception rejects the hello.
  using Factory = std::function<std::unique_ptr<Method>(const hello_t&)>;

  MethodHost(std::string name, Factory factory);

  /// Creates the method, once per hello id. Throws MethodError for a different protocol version.
  ready_t handle_hello(const hello_t& hello);
  /// Remembers the heading for the run_start_t of its run.
  void handle_goal_heading(const goal_heading_t& message) { goal_heading_ = message; }
  /// Throws what the method throws, or MethodError if no hello was received.
  ready_t handle_run_start(const run_start_t& message);
  /// Throws what the method throws.
  std::optional<command_t> handle_observation(const observation_t& message);

 private:
  ready_t ready(std::int64_t id) const;

  std::string name_;
  Factory factory_;
  SensorModel sensor_;
  std::unique_ptr<Method> method_;
  std::int64_t hello_id_ = 0, run_id_ = 0, next_sequence_ = -1;
  goal_heading_t goal_heading_ = {};
  ReceivedScan scan_;
};

/// Serves a simulator over LCM until `stop`, polled every 0.1 s, returns true. Exceptions are sent
/// as error_t. Throws Error (Job) when LCM is not available.
void serve_method(MethodHost& host, const std::string& url, const std::string& channel,
                  const std::function<bool()>& stop);

/// Result of comparing a method with a log.
struct LogReplay {
  std::size_t runs = 0, observations = 0, commands = 0;
  std::size_t different = 0;     ///< commands that differ from the logged ones (bitwise comparison)
  std::string first_difference;  ///< human-readable description
};

/// Replays the observations of an lcm-logger log through a method and compares its commands with
/// the logged ones. Each channel prefix gets its own host, created by `make_host`. Throws Error
/// (File) for a log that cannot be read or contains no observations.
LogReplay replay_log(const std::string& path, const std::function<MethodHost()>& make_host);

}  // namespace slalom
