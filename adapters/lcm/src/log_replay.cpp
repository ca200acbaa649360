#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/lcm/method_host.h>

#include <lcm/lcm-cpp.hpp>

#include <cstring>
#include <map>

namespace slalom {
namespace {

bool same_bits(const Command& a, const Command& b) {
  const double left[] = {a.v, a.w, a.vy}, right[] = {b.v, b.w, b.vy};
  return std::memcmp(left, right, sizeof left) == 0;
}

std::string text_of(const Command& command) {
  return "(" + format_number(command.v) + ", " + format_number(command.w) + ", " +
         format_number(command.vy) + ")";
}

/// The method on one prefix of channels, and what it answered last.
struct Line {
  explicit Line(MethodHost made) : host(std::move(made)) {}
  MethodHost host;
  std::optional<command_t> answer;
};

class Replayer {
 public:
  explicit Replayer(const std::function<MethodHost()>& make_host) : make_host_(make_host) {}

  void play(const lcm::LogEvent& event) {
    if (const auto prefix = prefix_of(event.channel, LcmChannels("").hello)) {
      hello_t hello;
      if (decode(event, hello)) line(*prefix).host.greet(hello);
    } else if (const auto prefix = prefix_of(event.channel, LcmChannels("").run_start)) {
      run_start_t message;
      if (!decode(event, message)) return;
      line(*prefix).host.start(message);
      ++result_.runs;
    } else if (const auto prefix = prefix_of(event.channel, LcmChannels("").observation)) {
      observe(event, line(*prefix));
    } else if (const auto prefix = prefix_of(event.channel, LcmChannels("").command)) {
      compare(event, line(*prefix));
    }
  }

  const LogReplay& result() const { return result_; }

 private:
  static std::optional<std::string> prefix_of(const std::string& channel,
                                              const std::string& suffix) {
    if (channel.size() < suffix.size()) return std::nullopt;
    const std::size_t at = channel.size() - suffix.size();
    if (channel.compare(at, suffix.size(), suffix) != 0) return std::nullopt;
    return channel.substr(0, at);
  }

  template <typename Message>
  static bool decode(const lcm::LogEvent& event, Message& message) {
    return event.datalen >= 0 &&
           decode_message(event.data, static_cast<std::size_t>(event.datalen), message);
  }

  Line& line(const std::string& prefix) {
    const auto known = lines_.find(prefix);
    if (known != lines_.end()) return known->second;
    return lines_.emplace(prefix, make_host_()).first->second;
  }

  void observe(const lcm::LogEvent& event, Line& line) {
    observation_t message;
    if (!decode(event, message)) return;
    ++result_.observations;
    line.answer = line.host.answer(message);
  }

  /// Only the first answer to an observation counts, as in the run.
  void compare(const lcm::LogEvent& event, Line& line) {
    command_t logged;
    if (!decode(event, logged) || !line.answer) return;
    if (logged.run_id != line.answer->run_id || logged.sequence != line.answer->sequence) return;
    ++result_.commands;
    const Command was = command_of(logged), is = command_of(*line.answer);
    line.answer.reset();
    if (same_bits(was, is)) return;
    if (++result_.different == 1)
      result_.first_difference = "observation " + std::to_string(logged.sequence) + " of run " +
                                 std::to_string(result_.runs) + ": " + text_of(is) +
                                 " instead of " + text_of(was);
  }

  const std::function<MethodHost()>& make_host_;
  std::map<std::string, Line> lines_;
  LogReplay result_;
};

}  // namespace

LogReplay replay_log(const std::string& path, const std::function<MethodHost()>& make_host) {
  lcm::LogFile log(path, "r");
  if (!log.good()) throw file_error(path, "cannot be read", "a log of lcm-logger");
  Replayer replayer(make_host);
  while (const lcm::LogEvent* event = log.readNextEvent()) replayer.play(*event);
  if (replayer.result().observations == 0)
    throw file_error(path, "has no observations of a run", "a log of lcm-logger");
  return replayer.result();
}

}  // namespace slalom
