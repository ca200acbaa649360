#include "external_process.h"
#include "method_link.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/lcm/lcm_method.h>

#include <filesystem>
#include <iomanip>
#include <random>
#include <sstream>
#include <unistd.h>

namespace slalom {
namespace {

using namespace std::chrono_literals;
using Clock = MethodLink::Clock;

constexpr int kMostAtOnce = 100;  // messages taken without a look at the clock

Clock::duration seconds(double count) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(count));
}

/// Not a result: only keeps what different simulators say apart.
std::uint32_t random_number() {
  return std::random_device()();
}

/// Below 2^53, so that languages whose numbers are all floating point tell the ids apart, too.
std::int64_t first_id() {
  return static_cast<std::int64_t>(random_number() >> 4U) << 24U;
}

/// Several methods of several processes, perhaps of several machines, hear the same group.
std::string channel_of_its_own(const std::string& prefix) {
  static int count = 0;
  std::ostringstream name;
  name << prefix << '_' << getpid() << '_' << ++count << '_' << std::hex << random_number();
  return name.str();
}

std::string folder_of(const IniFile& ini) {
  return std::filesystem::absolute(ini.name()).parent_path().string();
}

/// A process that is reached over LCM, on the simulator's side.
class LcmMethod : public Method {
 public:
  LcmMethod(const LcmOptions& options, hello_t hello, const std::string& channel,
            const std::string& folder)
      : options_(options),
        hello_(std::move(hello)),
        link_(options.url, channel),
        environment_({{"SLALOM_LCM_URL", options.url},
                      {"SLALOM_LCM_CHANNEL", channel},
                      {"SLALOM_INI_FOLDER", folder}}),
        id_(first_id()) {}

  bool good() const { return link_.good(); }

  /// Starts the process where that is our business, and tells it what the robot is like.
  void connect() {
    greeted_ = false;
    if (!options_.launch.empty() && !process_)
      process_ = std::make_unique<ExternalProcess>(options_.launch, environment_);
    greet();
    check_version();
    greeted_ = true;
  }

  void reset(const Task& task) override {
    if (process_ && process_->ended()) abandon();  // between two runs: that spoils neither
    // A process that somebody else starts may be another one by now.
    if (!greeted_ || options_.launch.empty()) connect();
    link_.expect(++id_);
    link_.send(make_run_start(id_, task));
    await([this] { return link_.ready().has_value(); }, options_.deadline, "run's start");
    observation_.run_id = id_;
    observation_.sequence = heard_ = -1;
    period_ = seconds(task.control_period);
    next_cycle_ = last_heard_ = Clock::now();
  }

  Command step(const Observation& observation) override {
    return options_.realtime() ? step_in_real_time(observation) : step_in_lockstep(observation);
  }

  void finish(const std::string& outcome) override {
    if (!greeted_) return;
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
    send(observation);
    await([this] { return link_.command() && link_.command()->sequence == observation_.sequence; },
          options_.deadline, "observation");
    return command_of(*link_.command());
  }

  /// The command in force at this instant of the wall clock. A late simulator does not hurry.
  Command step_in_real_time(const Observation& observation) {
    do listen(next_cycle_);
    while (Clock::now() < next_cycle_);
    next_cycle_ = std::max(next_cycle_ + period_, Clock::now());
    check_health();
    if (Clock::now() - last_heard_ > seconds(options_.deadline)) give_up("observations");
    send(observation);
    return link_.command() ? command_of(*link_.command()) : Command{};
  }

  /// Waits for something and takes what else is there; a flood of messages does not hold it up.
  void listen(Clock::time_point until) {
    bool more = link_.wait_until(until);
    for (int i = 0; i < kMostAtOnce && more; ++i) more = link_.wait_until(Clock::now());
    const std::int64_t heard = link_.command() ? link_.command()->sequence : -1;
    if (heard > heard_) last_heard_ = Clock::now();
    heard_ = heard;
  }

  /// Says hello until somebody answers: a process that is starting may not hear the first ones.
  void greet() {
    hello_.id = ++id_;
    link_.expect(id_);
    const auto until = Clock::now() + seconds(options_.startup_time);
    while (!link_.ready()) {
      link_.send(hello_);
      const auto again = Clock::now() + 10ms;
      while (!link_.ready() && Clock::now() < again)
        if (!link_.wait_until(again)) check_health();
      check_error();
      if (Clock::now() >= until && !link_.ready()) give_up("hello", options_.startup_time);
    }
  }

  void check_version() {
    const std::int32_t version = link_.ready()->protocol_version;
    if (version == kLcmProtocolVersion) return;
    process_.reset();
    throw MethodError("the external process speaks version " + std::to_string(version) +
                      " of the protocol; expected version " + std::to_string(kLcmProtocolVersion));
  }

  template <typename Done>
  void await(Done done, double limit, const std::string& what) {
    const auto until = Clock::now() + seconds(limit);
    while (!done()) {
      const bool came = link_.wait_until(until);
      if (done()) return;
      if (came)
        check_error();
      else
        check_health();
      if (Clock::now() >= until) give_up(what, limit);
    }
  }

  void check_error() const {
    if (link_.error()) throw MethodError("the external process says: " + link_.error()->text);
  }

  /// What a process said last tells more than how it ended.
  void check_health() {
    check_error();
    if (!process_) return;
    const auto end = process_->ended();
    if (!end) return;
    for (int i = 0; i < kMostAtOnce && link_.wait_until(Clock::now() + 5ms); ++i) continue;
    abandon();
    check_error();
    throw MethodError("the external process ended (" + *end + ")");
  }

  [[noreturn]] void give_up(const std::string& what) { give_up(what, options_.deadline); }

  [[noreturn]] void give_up(const std::string& what, double limit) {
    const int undecodable = link_.undecodable();
    abandon();
    throw MethodTimeout(
        "no answer of the external process to the " + what + " within " + format_number(limit) +
        " s of wall-clock time" +
        (undecodable == 0 ? ""
                          : "; messages that cannot be decoded: " + std::to_string(undecodable)));
  }

  /// The next run begins with a new process.
  void abandon() {
    process_.reset();
    greeted_ = false;
  }

  LcmOptions options_;
  hello_t hello_;
  MethodLink link_;
  EnvironmentVariables environment_;
  std::unique_ptr<ExternalProcess> process_;
  std::int64_t id_;  ///< of the last hello or run
  bool greeted_ = false;
  observation_t observation_ = {};
  Clock::duration period_{};
  Clock::time_point next_cycle_, last_heard_;
  std::int64_t heard_ = -1;
};

}  // namespace

std::unique_ptr<Method> make_lcm_method(const MethodContext& context) {
  const LcmOptions options = read_lcm_options(context.ini, context.section);
  const hello_t hello =
      make_hello(context.section.substr(context.section.find('.') + 1), context.robot,
                 context.sensor, own_settings(context.ini, context.section));
  const bool launches = !options.launch.empty();
  auto method = std::make_unique<LcmMethod>(
      options, hello, launches ? channel_of_its_own(options.channel) : options.channel,
      folder_of(context.ini));
  if (!method->good())
    throw usage_error(context.ini.where(context.section, "url"),
                      "LCM cannot be used with '" + options.url + "'",
                      "a provider's address and, for udpm, a network interface with multicast");
  if (!launches) return method;
  try {
    method->connect();
  } catch (const std::runtime_error& failure) {
    throw usage_error(context.ini.where(context.section, "launch"), failure.what());
  }
  return method;
}

}  // namespace slalom
