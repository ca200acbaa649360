// SPDX-License-Identifier: BSD-3-Clause
#include "method_link.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/lcm/lcm_method.h>
#include <slalom/methods/external_process.h>
#include <slalom/methods/registry.h>

#include <filesystem>
#include <iomanip>
#include <random>
#include <sstream>
#include <unistd.h>

namespace slalom {
namespace {

/// LCM's channel names have at most 63 characters; the rest is for the instance and the message.
constexpr std::size_t kMaxChannel = 24;

/// Ports that the system does not give to other sockets by itself.
constexpr int kFirstPort = 10000, kPorts = 22768;
constexpr int kPortsOfProcess = 64;  ///< then those of the next process follow
constexpr int kOtherPorts = 3;       ///< tried if one is in use

constexpr int kMaxBatch = 100;  // messages handled before the clock is checked again

/// Does not affect results: only distinguishes the messages of different simulators.
std::uint32_t random_number() {
  return std::random_device()();
}

/// Below 2^53, so that ids are exact in languages with floating point numbers only.
std::int64_t first_id() {
  return static_cast<std::int64_t>(random_number() >> 4U) << 24U;
}

/// Several methods, processes and machines may share one multicast group.
std::string unique_channel(const std::string& prefix) {
  static int count = 0;
  std::ostringstream name;
  name << prefix << '_' << getpid() << '_' << ++count << '_' << std::hex << random_number();
  return name.str();
}

/// The URL of a launched process without another one.
std::string unique_url() {
  static int count = 0;
  const std::string url = kLcmUrl;
  const std::size_t port = url.rfind(':') + 1;
  const long number = (static_cast<long>(getpid()) * kPortsOfProcess + count++) % kPorts;
  return url.substr(0, port) + std::to_string(kFirstPort + number) + url.substr(url.find('?'));
}

void check_channel(const LcmOptions& options, const OptionLocation& where) {
  if (options.channel.empty() || options.channel.size() > kMaxChannel)
    throw usage_error(where("channel"), "invalid channel '" + options.channel + "'",
                      "1 to " + std::to_string(kMaxChannel) + " characters");
}

/// The simulator's side of an external method.
class LcmMethod : public Method {
 public:
  LcmMethod(const LcmOptions& options, hello_t hello, const std::string& channel, WallClock clock)
      : options_(options),
        clock_(std::move(clock)),
        hello_(std::move(hello)),
        link_(options.url, channel),
        environment_({{"SLALOM_LCM_URL", options.url},
                      {"SLALOM_LCM_CHANNEL", channel},
                      {"PYTHONUNBUFFERED", "1"},  // what it prints is of its run
                      {"SLALOM_INI_FOLDER", options.folder}}),
        id_(first_id()) {}

  bool good() const { return link_.good(); }

  /// Starts the process if it is to be launched, and sends it the robot, the sensor and settings.
  void connect() {
    connected_ = false;
    if (!options_.launch.empty() && !process_)
      process_ = std::make_unique<ExternalProcess>(options_.launch, environment_);
    handshake();
    check_version();
    connected_ = true;
  }

  void reset(const NavigationTask& task) override {
    if (process_ && process_->exit_description())
      stop_process();  // exited between two runs: no run fails
    // A process that was started elsewhere may have been replaced.
    if (!connected_ || options_.launch.empty()) connect();
    link_.expect_replies_to(++id_);
    if (task.goal_heading) link_.send(make_goal_heading(id_, task));
    link_.send(make_run_start(id_, task));
    wait_for([this] { return link_.ready().has_value(); }, options_.deadline, "run start");
    observation_.run_id = id_;
    observation_.sequence = last_sequence_ = -1;
    period_ = task.control_period;
    next_cycle_ = last_command_time_ = clock_();
  }

  Command step(const Observation& observation) override {
    return options_.mode == LcmMode::Realtime ? step_in_real_time(observation)
                                              : step_in_lockstep(observation);
  }

  void finish(const std::string& outcome) override {
    if (!connected_) return;
    run_end_t message = {};
    message.run_id = id_;
    message.outcome = outcome;
    link_.send(message);
  }

 private:
  void send(const Observation& observation) {
    fill_observation(observation, observation_);
    ++observation_.sequence;
    link_.send(observation_);
  }

  Command step_in_lockstep(const Observation& observation) {
    check_error();
    send(observation);
    wait_for(
        [this] { return link_.command() && link_.command()->sequence == observation_.sequence; },
        options_.deadline, "observation");
    return command_of(*link_.command());
  }

  /// Returns the latest command at the end of the period. After a delay no cycle is shortened.
  Command step_in_real_time(const Observation& observation) {
    do receive_until(next_cycle_);
    while (clock_() < next_cycle_);
    next_cycle_ = std::max(next_cycle_ + period_, clock_());
    check_health();
    if (clock_() - last_command_time_ > options_.deadline) throw_timeout("observations");
    send(observation);
    return link_.command() ? command_of(*link_.command()) : Command{};
  }

  /// Waits for a message and handles all pending ones, up to a limit.
  void receive_until(double until) {
    bool more = wait_until(until);
    for (int i = 0; i < kMaxBatch && more; ++i) more = link_.wait(0);
    const std::int64_t sequence = link_.command() ? link_.command()->sequence : -1;
    if (sequence > last_sequence_) last_command_time_ = clock_();
    last_sequence_ = sequence;
  }

  /// Repeats the hello until it is answered: a process that is starting may miss the first ones.
  void handshake() {
    hello_.id = ++id_;
    link_.expect_replies_to(id_);
    const double until = clock_() + options_.startup_time;
    while (!link_.ready()) {
      link_.send(hello_);
      const double resend = clock_() + 0.01;
      while (!link_.ready() && clock_() < resend)
        if (!wait_until(resend)) check_health();
      check_error();
      if (clock_() >= until && !link_.ready())
        throw_timeout("hello at " + options_.url, options_.startup_time);
    }
  }

  /// Waits for a message, but not longer than one poll, so that the process can be monitored.
  bool wait_until(double until) { return link_.wait(until - clock_()); }

  void check_version() {
    const std::int32_t version = link_.ready()->protocol_version;
    if (version == kLcmProtocolVersion) return;
    process_.reset();
    throw MethodError("the external process uses protocol version " + std::to_string(version) +
                      "; expected version " + std::to_string(kLcmProtocolVersion));
  }

  template <typename Done>
  void wait_for(Done done, double limit, const std::string& what) {
    const double until = clock_() + limit;
    while (!done()) {
      const bool received = wait_until(until);
      if (done()) return;
      if (received)
        check_error();
      else
        check_health();
      if (clock_() >= until) throw_timeout(what, limit);
    }
  }

  void check_error() const {
    if (link_.error()) throw MethodError("the external process reported: " + link_.error()->text);
    if (link_.conflict())
      throw MethodError("two different commands for one observation: another program answers, too");
  }

  /// An error reported by the process takes precedence over its exit status.
  void check_health() {
    check_error();
    if (!process_) return;
    const auto end = process_->exit_description();
    if (!end) return;
    for (int i = 0; i < kMaxBatch && link_.wait(0.005); ++i) continue;
    stop_process();
    check_error();
    throw MethodError("the external process ended (" + *end + ")");
  }

  [[noreturn]] void throw_timeout(const std::string& what) {
    throw_timeout(what, options_.deadline);
  }

  [[noreturn]] void throw_timeout(const std::string& what, double limit) {
    const int undecodable = link_.undecodable();
    stop_process();
    throw MethodTimeout(
        "no answer from the external process to the " + what + " within " + format_number(limit) +
        " s of wall-clock time" +
        (undecodable == 0 ? ""
                          : "; messages that cannot be decoded: " + std::to_string(undecodable)));
  }

  /// The next run starts a new process.
  void stop_process() {
    process_.reset();
    connected_ = false;
  }

  LcmOptions options_;
  WallClock clock_;
  hello_t hello_;
  MethodLink link_;
  EnvironmentVariables environment_;
  std::unique_ptr<ExternalProcess> process_;
  std::int64_t id_;  ///< of the last hello or run
  bool connected_ = false;
  observation_t observation_ = {};
  double period_ = 0, next_cycle_ = 0, last_command_time_ = 0;  ///< s
  std::int64_t last_sequence_ = -1;
};

std::unique_ptr<Method> make_method(LcmOptions options, const hello_t& hello,
                                    const OptionLocation& where, const WallClock& clock) {
  const bool launches = !options.launch.empty();
  const std::string channel = launches ? unique_channel(options.channel) : options.channel;
  const bool has_own_port = launches && options.url.empty();
  if (options.url.empty()) options.url = launches ? unique_url() : kLcmUrl;
  auto method = std::make_unique<LcmMethod>(options, hello, channel, clock);
  for (int i = 0; i < kOtherPorts && has_own_port && !method->good(); ++i) {
    options.url = unique_url();
    method = std::make_unique<LcmMethod>(options, hello, channel, clock);
  }
  if (!method->good())
    throw usage_error(where("url"), "LCM cannot be used with '" + options.url + "'",
                      "an LCM provider URL and, for udpm, a network interface with multicast");
  if (!launches) return method;
  try {
    method->connect();
  } catch (const std::runtime_error& failure) {
    throw usage_error(where("launch"), failure.what());
  }
  return method;
}

MethodFactory make_factory(const LcmOptions& options, const OptionLocation& where,
                           const WallClock& clock) {
  check_channel(options, where);
  return [=](const RobotModel& robot, const SensorModel& sensor) {
    return make_method(options, make_hello(options.name, robot, sensor, options.settings), where,
                       clock);
  };
}

}  // namespace

MethodFactory lcm_method(const LcmOptions& options, const WallClock& clock) {
  check_options(options, location_of("lcm_method"));
  return make_factory(options, location_of("lcm_method"), clock);
}

MethodFactory read_lcm_method(const IniFile& ini, const std::string& section,
                              const WallClock& clock) {
  LcmOptions options;
  AdapterReader reader(ini, section);
  options.visit(reader);
  options.name = section.substr(section.find('.') + 1);
  options.folder = std::filesystem::absolute(ini.name()).parent_path().string();
  for (const auto& [key, value] : reader.unvisited()) options.settings[key] = value;
  return make_factory(options, location_in(ini, section), clock);
}

}  // namespace slalom
