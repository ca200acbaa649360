// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/lcm/method_host.h>

#include <lcm/lcm-cpp.hpp>

#include <map>

namespace slalom {
namespace {

bool same_command(const Command& a, const Command& b) {
  return same_bits(a.v, b.v) && same_bits(a.w, b.w) && same_bits(a.vy, b.vy);
}

std::string text_of(const Command& command) {
  return "(" + format_number(command.v) + ", " + format_number(command.w) + ", " +
         format_number(command.vy) + ")";
}

/// The method on one channel prefix, and its last command.
struct MethodChannel {
  explicit MethodChannel(MethodHost method_host) : host(std::move(method_host)) {}
  MethodHost host;
  std::optional<command_t> command;
};

class Replayer {
 public:
  explicit Replayer(const std::function<MethodHost()>& make_host) : make_host_(make_host) {}

  void play(const lcm::LogEvent& event) {
    if (const auto hello_prefix = prefix_of(event.channel, LcmChannels("").hello)) {
      hello_t hello;
      if (decode(event, hello)) channel_for(*hello_prefix).host.handle_hello(hello);
    } else if (const auto heading_prefix = prefix_of(event.channel, LcmChannels("").goal_heading)) {
      goal_heading_t message;
      if (decode(event, message)) channel_for(*heading_prefix).host.handle_goal_heading(message);
    } else if (const auto run_start_prefix = prefix_of(event.channel, LcmChannels("").run_start)) {
      run_start_t message;
      if (!decode(event, message)) return;
      channel_for(*run_start_prefix).host.handle_run_start(message);
      ++result_.runs;
    } else if (const auto observation_prefix =
                   prefix_of(event.channel, LcmChannels("").observation)) {
      observe(event, channel_for(*observation_prefix));
    } else if (const auto command_prefix = prefix_of(event.channel, LcmChannels("").command)) {
      compare(event, channel_for(*command_prefix));
    }
  }

  const LogReplay& result() const { return result_; }

 private:
  static std::optional<std::string> prefix_of(const std::string& channel,
                                              const std::string& suffix) {
    if (!ends_with(channel, suffix)) return std::nullopt;
    return channel.substr(0, channel.size() - suffix.size());
  }

  template <typename Message>
  static bool decode(const lcm::LogEvent& event, Message& message) {
    return event.datalen >= 0 &&
           decode_message(event.data, static_cast<std::size_t>(event.datalen), message);
  }

  MethodChannel& channel_for(const std::string& prefix) {
    const auto known = channels_.find(prefix);
    if (known != channels_.end()) return known->second;
    return channels_.emplace(prefix, make_host_()).first->second;
  }

  void observe(const lcm::LogEvent& event, MethodChannel& channel) {
    observation_t message;
    if (!decode(event, message)) return;
    ++result_.observations;
    channel.command = channel.host.handle_observation(message);
  }

  /// Only the first reply to an observation counts, as in the run.
  void compare(const lcm::LogEvent& event, MethodChannel& channel) {
    command_t logged;
    if (!decode(event, logged) || !channel.command) return;
    if (logged.run_id != channel.command->run_id || logged.sequence != channel.command->sequence)
      return;
    ++result_.commands;
    const Command was = command_of(logged), is = command_of(*channel.command);
    channel.command.reset();
    if (same_command(was, is)) return;
    if (++result_.different == 1)
      result_.first_difference = "observation " + std::to_string(logged.sequence) + " of run " +
                                 std::to_string(result_.runs) + ": " + text_of(is) +
                                 " instead of " + text_of(was);
  }

  const std::function<MethodHost()>& make_host_;
  std::map<std::string, MethodChannel> channels_;
  LogReplay result_;
};

}  // namespace

LogReplay replay_log(const std::string& path, const std::function<MethodHost()>& make_host) {
  const std::string kind = "a log of lcm-logger";
  require_regular_file(path, kind);
  lcm::LogFile log(path, "r");
  if (!log.good()) throw file_error(path, "cannot be read", kind);
  Replayer replayer(make_host);
  while (const lcm::LogEvent* event = log.readNextEvent()) replayer.play(*event);
  if (replayer.result().observations == 0)
    throw file_error(path, "contains no observations of a run", kind);
  return replayer.result();
}

}  // namespace slalom
