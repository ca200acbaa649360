// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/lcm/protocol.h>

#include <lcm/lcm-cpp.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The simulator's side of the connection to an external method: sends messages and keeps the
/// replies of the current run. Undecodable messages, messages of other runs, with other sequence
/// numbers, and duplicates are dropped.
class MethodLink {
 public:
  MethodLink(const std::string& url, const std::string& prefix);

  /// Whether LCM was initialized.
  bool good() const { return good_; }

  /// Clears all replies; from now on only replies to this hello id or run id are accepted.
  void expect_replies_to(std::int64_t id);
  void send(const hello_t& hello);
  void send(const goal_heading_t& message);
  void send(const run_start_t& message);
  void send(const run_end_t& message);
  /// From now on commands up to its sequence number are accepted.
  void send(const observation_t& message);

  /// Waits for a message, at most `seconds` and at most 10 ms. Returns false if none was received.
  bool wait(double seconds);

  const std::optional<ready_t>& ready() const { return ready_; }
  const std::optional<error_t>& error() const { return error_; }
  /// The received command with the highest sequence number.
  const std::optional<command_t>& command() const { return command_; }
  /// Whether two commands for one observation differed, among the last hundred observations:
  /// another program answers on this channel, or the process answers twice.
  bool conflict() const { return conflict_; }
  int undecodable() const { return undecodable_; }  ///< messages since expect_replies_to()

 private:
  template <typename Message>
  void publish(const std::string& channel, const Message& message);
  template <typename Message, void (MethodLink::*take)(const Message&)>
  static void receive(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                      MethodLink* link);
  void on_ready(const ready_t& message);
  void on_command(const command_t& message);
  void on_error(const error_t& message);
  bool handle(int milliseconds);

  LcmChannels channels_;
  lcm::LCM lcm_;
  bool good_ = false;
  std::int64_t id_ = 0;
  std::int64_t sent_ = -1;  ///< sequence number of the last observation
  std::vector<unsigned char> bytes_;
  std::optional<ready_t> ready_;
  std::optional<command_t> command_;
  std::map<std::int64_t, command_t> commands_;  ///< the last ones, by sequence number
  bool conflict_ = false;
  std::optional<error_t> error_;
  int undecodable_ = 0;
};

}  // namespace slalom
