#pragma once

#include <slalom/lcm/protocol.h>

#include <lcm/lcm-cpp.hpp>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The simulator's end of the line to an external method: sends, and keeps what came and belongs to
/// the present run. Messages that cannot be decoded, of another run, with another sequence number,
/// or that come twice are dropped.
class MethodLink {
 public:
  using Clock = std::chrono::steady_clock;

  MethodLink(const std::string& url, const std::string& prefix);

  /// Whether LCM could be set up.
  bool good() const { return good_; }

  /// From now on answers to the hello or run with this number count; nothing has come yet.
  void expect(std::int64_t id);
  void send(const hello_t& hello);
  void send(const run_start_t& message);
  void send(const run_end_t& message);
  /// An answer with its sequence number, or a lower one that has not come yet, counts from now on.
  void send(const observation_t& message);

  /// Waits until something came, at most until then; false when nothing did.
  bool wait_until(Clock::time_point until);

  const std::optional<ready_t>& ready() const { return ready_; }
  const std::optional<error_t>& error() const { return error_; }
  /// The one with the highest sequence number of those that have come.
  const std::optional<command_t>& command() const { return command_; }
  int undecodable() const { return undecodable_; }  ///< messages since expect()

 private:
  template <typename Message>
  void publish(const std::string& channel, const Message& message);
  template <typename Message, void (MethodLink::*take)(const Message&)>
  static void receive(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                      MethodLink* link);
  void take_ready(const ready_t& message);
  void take_command(const command_t& message);
  void take_error(const error_t& message);
  bool handle(int milliseconds);

  LcmChannels channels_;
  lcm::LCM lcm_;
  bool good_ = false;
  std::int64_t id_ = 0;
  std::int64_t sent_ = -1;  ///< sequence number of the last observation
  std::vector<unsigned char> bytes_;
  std::optional<ready_t> ready_;
  std::optional<command_t> command_;
  std::optional<error_t> error_;
  int undecodable_ = 0;
};

}  // namespace slalom
