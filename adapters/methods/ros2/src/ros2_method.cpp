// SPDX-License-Identifier: BSD-3-Clause
#include "ros2_link.h"
#include "ros_domain.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/output_marks.h>
#include <slalom/core/scratch_folder.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>
#include <slalom/library/shared_library.h>
#include <slalom/methods/external_process.h>
#include <slalom/methods/goal_turn.h>
#include <slalom/methods/registry.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>

namespace slalom {
namespace {

constexpr char kRuntime[] = "runtime/libslalom_ros2_runtime.so";

constexpr RosTime kSecond = 1'000'000'000;
/// The rest before a run begins at a multiple of it, so that runs begin at the same phase of the
/// nodes' timers.
constexpr RosTime kGrid = 10 * kSecond;
/// The robot stands at its start for at least this time, so that transforms and costmaps fill.
constexpr double kRest = 1;             // s, simulated
constexpr double kGoalPeriod = 1;       // s, until nodes that are starting have read the goal
constexpr double kSettlingTime = 0.02;  // s, for commands beyond those that are expected
/// The waits for a command of nodes that may not be ready, s: so many short ones, then longer ones.
constexpr double kShortWait = 0.02, kLongWait = 0.64;
constexpr int kShortWaits = 10;
/// The least and longest time without commands until earlier ones count as received, s.
constexpr double kShortQuiet = 0.06, kLongQuiet = 2.5;
constexpr double kNamingTime = 1;       // s, until the nodes of publishers are announced
constexpr double kHealthPeriod = 0.05;  // s, between two looks at the process
constexpr double kClockPeriod = 1;      // s, of wall-clock time, until /clock is sent again

/// The steps of simulated time while nodes start, ns, each after a time of the wall clock, s. In
/// lock-step they are whole seconds: timers of nodes keep their phase, whenever they are made.
constexpr RosTime kStartingStep = kSecond / 20, kStartingStepInLockstep = kSecond;
constexpr double kStartingPeriod = 0.05, kStartingPeriodInLockstep = 0.25;
/// The free map of a check, in which there is no scenario: its side and its cells, m.
constexpr double kCheckedMap = 10, kCheckedCell = 0.1;

RosTime nanoseconds(double seconds) {
  return static_cast<RosTime>(std::llround(seconds * 1e9));
}

/// Later than the time of an earlier program that was at most 1000 times as fast as real time:
/// running nodes outlive the simulator, and their time should not go back. It does every 23 days,
/// since seconds of ROS have 31 bits.
RosTime time_of_running_nodes() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now).count();
  return seconds % 2'000'000 * 1000 * kSecond;
}

/// Distributions since Iron (names follow the alphabet) warn of the variable before it.
bool knows_discovery_range() {
  const char* distribution = std::getenv("ROS_DISTRO");
  return distribution != nullptr && std::string(distribution) >= "iron";
}

/// Scans without any return.
std::vector<mrpt::obs::CObservation2DRangeScan> empty_scans(const SensorModel& sensor) {
  std::vector<mrpt::obs::CObservation2DRangeScan> scans;
  for (const LaserModel& laser : sensor.all_lasers())
    scans.emplace_back().resizeScanAndAssign(static_cast<std::size_t>(laser.rays), 0, false);
  return scans;
}

/// The simulator's side of the nodes.
class Ros2Method : public Method {
 public:
  using MakeLink = std::function<std::unique_ptr<RosLink>()>;

  Ros2Method(const Ros2Options& options, const RobotModel& robot, const SensorModel& sensor,
             int domain, WallClock clock, MakeLink make_link, OptionLocation where)
      : options_(options),
        barrier_(barrier_nodes(options)),
        parameters_(node_parameters(options)),
        robot_(robot),
        sensor_(sensor),
        environment_({{"ROS_DOMAIN_ID", std::to_string(domain)},
                      {"ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST"},
                      {"PYTHONUNBUFFERED", "1"}}),  // what they print is of their run
        clock_(std::move(clock)),
        make_link_(std::move(make_link)),
        where_(std::move(where)),
        last_(options.launch.empty() ? time_of_running_nodes() : 0) {
    if (!knows_discovery_range()) environment_.emplace_back("ROS_LOCALHOST_ONLY", "1");
    if (!options.rmw.empty()) environment_.emplace_back("RMW_IMPLEMENTATION", options.rmw);
    if (!parameters_.empty() && !options.launch.empty()) {
      folder_.emplace();
      const std::string file = folder_->path() + "/parameters.yaml";
      std::ofstream(file) << parameter_file_text(parameters_);
      environment_.emplace_back("SLALOM_PARAMETERS", file);
    }
  }

  bool uses_map() const override { return options_.map == Ros2Map::Known; }
  bool is_paced() const override { return options_.mode == Ros2Mode::Realtime; }

  /// Launches the nodes, if they are to be launched.
  void start() {
    if (!link_) link_ = make_link_();
    if (!options_.launch.empty() && !process_)
      process_ = std::make_unique<ExternalProcess>(options_.launch, environment_);
  }

  /// The nodes, if they are to be launched, find a robot that rests in the middle of an empty
  /// world.
  void check() override {
    if (options_.launch.empty()) return;
    start();
    if (uses_map()) {
      constexpr auto kSide = static_cast<std::size_t>(kCheckedMap / kCheckedCell);
      const std::vector<std::uint8_t> cells(kSide * kSide);
      link_->send_map({kCheckedCell, {-kCheckedMap / 2, -kCheckedMap / 2}, kSide, kSide, &cells},
                      last_);
    }
    const auto scans = empty_scans(sensor_);
    Observation nothing;
    nothing.scan = &scans.front();
    if (!sensor_.lasers.empty())
      for (const auto& scan : scans) nothing.lasers.push_back(&scan);
    try {
      await_nodes(nothing);
    } catch (const NodeParameterError& refusal) {
      throw usage_error(where_("parameter_set"), refusal.what());
    } catch (const std::runtime_error& failure) {
      throw usage_error(where_("launch"), failure.what());
    }
    const double until = clock_() + kNamingTime;
    for (std::string excess; !(excess = excess_of(link_->publishers())).empty(); link_->wait(0.01))
      if (clock_() >= until) throw usage_error(where_("publishers"), excess);
  }

  void reset(const NavigationTask& task) override {
    // Nodes that exited between two runs: no run fails. Those that have served none are as new.
    const bool is_used = options_.restart == Ros2Restart::Run && served_;
    if (process_ && (is_used || process_->exit_description())) stop();
    start();
    if (uses_map()) link_->send_map(map_of(task), last_);
    figures_ = {{"commands_missing", 0},
                {"commands_stale", 0},
                {"commands_late", 0},
                {"commands_expired", 0},
                {"commands_limited", 0}};
    period_ = task.control_period;
    rested_ = false;
    command_ = {};
    goal_ = goal_pose(task);
  }

  /// The nodes find the robot at its start, and are there before they are given the goal. Simulated
  /// time passes at the start pose, at least kRest. In lock-step it passes in whole blocks of
  /// kRest, until the nodes have answered each observation of the last one: a node that has just
  /// appeared may have missed the first ones. Nodes that may be silent for a while, or publish at
  /// their own rate, have answered once.
  void settle(const Observation& observation) override {
    await_nodes(observation);
    if (uses_map()) link_->await_map();
    check_publishers();
    served_ = true;
    start_ = (last_ / kGrid + 1) * kGrid;
    take_commands();  // of before the goal
    link_->send_goal(goal_, start_);
    const int block = std::max(1, static_cast<int>(std::ceil(kRest / period_)));
    const bool each = !is_paced() && options_.patience == 0;
    last_command_time_ = clock_();
    const double until = clock_() + options_.startup_time;
    double next_goal = clock_() + kGoalPeriod;
    int answers = 0;
    double answered_at = clock_();
    longest_answer_ = 0;
    const auto is_within_block = [&](int cycle) {
      return is_paced() ? cycle < block : cycle == 0 || cycle % block != 0;
    };
    for (int cycle = 0; is_within_block(cycle) || answers < (each ? block : 1); ++cycle) {
      // A node that is configured may read scans for a moment only.
      const bool answered = (is_paced() ? is_commanded(observation) : is_answered(observation)) &&
                            link_->missing().empty();
      answers = answered ? answers + 1 : each ? 0 : answers;
      if (answered) answered_at = clock_();
      start_ += nanoseconds(period_);
      if (!answered_ && clock_() >= next_goal) {
        link_->send_goal(goal_, start_);
        next_goal += kGoalPeriod;
      }
      if (!answered_ && clock_() >= until)
        fail<MethodTimeout>("there is no command on " + command_topic() + " within " +
                            format_number(options_.startup_time) +
                            " s of wall-clock time after the goal");
      const double longest = std::max(options_.startup_time, options_.deadline);
      if (clock_() - answered_at >= longest)
        fail<MethodTimeout>("the nodes do not answer an observation with " +
                            std::to_string(options_.commands_per_cycle) + " on " + command_topic() +
                            " within " + format_number(longest) + " s of wall-clock time");
    }
    if (!is_paced() && !counted_) count_commands();
    take_commands();
    figures_["commands_stale"] = figures_["commands_late"] = 0;
    rested_ = true;
    next_cycle_ = last_command_time_ = clock_();
  }

  Command step(const Observation& observation) override {
    if (!rested_) settle(observation);
    const RosTime now = start_ + nanoseconds(observation.time);
    return is_paced() ? step_in_real_time(observation, now) : step_in_lockstep(observation, now);
  }

  std::map<std::string, double> run_figures() const override { return figures_; }

 private:
  /// Waits until all nodes are there and have their parameters. Nodes may read a topic only when
  /// they have others, and stop to read it while they are configured.
  void await_nodes(const Observation& resting) {
    const double until = clock_() + options_.startup_time;
    while (!connected_ || !link_->missing().empty()) {
      connected_ = false;
      for (std::vector<std::string> missing; !(missing = link_->missing()).empty();)
        wait_for<MethodTimeout>(join(missing, ", no "), until, resting);
      // Nodes may declare their parameters some time after they have appeared.
      for (std::size_t i = 0; i < parameters_.size(); ++i)
        for (std::string missing; !(missing = link_->set_parameter(i, kHealthPeriod)).empty();)
          wait_for<NodeParameterError>(missing, until, resting);
      connected_ = true;
      answered_ = counted_ = false;
      unanswered_ = 0;
    }
  }

  /// Waits a little for what is missing at the start.
  template <typename Failure>
  void wait_for(const std::string& missing, double until, const Observation& resting) {
    check_health();
    if (clock_() >= until)
      fail<Failure>("there is no " + missing + " after " + format_number(options_.startup_time) +
                    " s of wall-clock time");
    if (clock_() >= next_resting_) rest_while_starting(resting);
    take_commands();  // an unread one would end each wait
    link_->wait(0.01);
  }

  /// Publishes what a robot publishes that waits for its nodes.
  void rest_while_starting(const Observation& observation) {
    const RosTime step = is_paced() ? kStartingStep : kStartingStepInLockstep;
    last_ = (last_ / step + 1) * step;
    send_data(observation, last_, last_);
    link_->send_clock(last_);
    next_resting_ = clock_() + (is_paced() ? kStartingPeriod : kStartingPeriodInLockstep);
  }

  /// A node that publishes more commands than expected would be ahead of the data by one command,
  /// and then by another.
  void count_commands() {
    const double until = clock_() + std::max(kSettlingTime, 1.5 * longest_answer_);
    if (take_commands_until(until) > 0)
      fail<MethodError>("further commands on " + command_topic() +
                        " followed an observation, beyond commands_per_cycle = " +
                        std::to_string(options_.commands_per_cycle));
    counted_ = true;
  }

  /// Whether the nodes answered an observation of the rest. The wait grows until they answer: they
  /// may need longer than the least one, or may not be ready.
  bool is_answered(const Observation& observation) {
    take_commands();
    send(observation, start_);
    const double sent = clock_();
    if (answered_) {
      const bool answered = await_commands(patience());
      longest_answer_ = std::max(longest_answer_, clock_() - sent);
      if (!answered) check_silence();
      return answered;
    }
    if (unanswered_++ == 0) first_sent_ = sent;
    const double longer = std::ldexp(kShortWait, std::max(0, unanswered_ - kShortWaits));
    if (!await_commands(std::min({longer, kLongWait, patience()}))) return false;
    // Nodes need at most this time for an observation, if they were ready from the first one on;
    // that for the next one may be longer.
    drop_commands_until_quiet(std::clamp(3 * (clock_() - first_sent_), kShortQuiet, kLongQuiet));
    answered_ = true;
    return true;
  }

  /// Answers to earlier observations may be on their way.
  void drop_commands_until_quiet(double seconds) {
    const double last = clock_() + patience();
    while (clock_() < last && take_commands_until(std::min(clock_() + seconds, last)) > 0) {
    }
  }

  /// Whether there was a command since the last period of the rest.
  bool is_commanded(const Observation& observation) {
    const double end = clock_() + period_;
    send(observation, start_);
    const int commands = take_commands_until(end);
    if (answered_ && commands == 0) check_silence();
    answered_ = answered_ || commands > 0;
    return commands > 0;
  }

  Command step_in_lockstep(const Observation& observation, RosTime now) {
    figures_["commands_late"] += take_commands();
    send(observation, now);
    if (!await_commands(patience())) {
      figures_["commands_missing"] += 1;
      check_silence();
    }
    check_publishers();
    return limited_command(command_, robot_, figures_["commands_limited"]);
  }

  /// Returns the latest command at the end of the period. After a delay no cycle is shortened.
  Command step_in_real_time(const Observation& observation, RosTime now) {
    send(observation, now);
    next_cycle_ = std::max(next_cycle_ + period_, clock_());
    if (take_commands_until(next_cycle_) == 0) {
      figures_["commands_missing"] += 1;
      check_silence();
      if (options_.command_timeout > 0 &&
          clock_() - last_command_time_ >= options_.command_timeout) {
        figures_["commands_expired"] += 1;
        command_ = {};
      }
    }
    return limited_command(command_, robot_, figures_["commands_limited"]);
  }

  double patience() const { return options_.patience > 0 ? options_.patience : options_.deadline; }

  /// Sends the data of a cycle, then its time. The nodes' timers fire with the time, and must find
  /// the data.
  void send(const Observation& observation, RosTime now) {
    scan_time_ = now - nanoseconds(std::min(sensor_.latency, observation.time));
    send_data(observation, now, scan_time_);
    const RosTime step =
        options_.clock_step > 0 ? nanoseconds(options_.clock_step) : nanoseconds(period_);
    for (RosTime time = std::max(last_ + step, now - nanoseconds(period_) + step); time < now;
         time += step)
      link_->send_clock(time);
    link_->send_clock(now);
    last_ = now;
  }

  /// Scans are the last, and each topic waits at the barrier: a node that commands in the callback
  /// of its scan has the pose and the velocity of the same time.
  void send_data(const Observation& observation, RosTime now, RosTime scan_time) {
    link_->send_transform(observation, now);
    pass_barriers();
    link_->send_odometry(observation, now);
    pass_barriers();
    link_->send_scans(observation, scan_time);
    pass_barriers();
  }

  /// A node that is looking for work as the data arrive may find a question and miss the data. The
  /// second question is asked when they are there.
  void pass_barriers() {
    if (!connected_) return;
    for (std::size_t node = 0; node < barrier_.size(); ++node)
      for (int question = 0; question < 2; ++question) pass_barrier(node);
  }

  void pass_barrier(std::size_t node) {
    const double until = clock_() + options_.deadline;
    while (!link_->pass_barrier(node, kHealthPeriod)) {
      check_health();
      if (clock_() >= until)
        fail<MethodTimeout>("the node " + barrier_[node] +
                            " does not reply to the barrier within " +
                            format_number(options_.deadline) + " s of wall-clock time");
    }
  }

  /// Whether the commands of a cycle arrived within this time (s). Nodes read the time by best
  /// effort: what is lost is sent again, and has no effect on those that have it.
  bool await_commands(double seconds) {
    const double until = clock_() + seconds;
    double next_clock = clock_() + kClockPeriod;
    for (int count = 0; count < options_.commands_per_cycle;) {
      if (take_command()) {
        ++count;
        continue;
      }
      check_health();
      const double left = until - clock_();
      if (left <= 0) return false;
      if (clock_() >= next_clock) {
        link_->send_clock(last_);
        next_clock = clock_() + kClockPeriod;
      }
      link_->wait(std::min(left, kHealthPeriod));
    }
    return true;
  }

  bool take_command() {
    const auto command = link_->take_command();
    if (!command) return false;
    command_ = command->velocity;
    last_command_time_ = clock_();
    // Nodes that do not know the time of their data leave the stamp empty.
    if (command->stamp && *command->stamp > 0 && *command->stamp < scan_time_)
      figures_["commands_stale"] += 1;
    return true;
  }

  int take_commands() {
    int count = 0;
    while (take_command()) ++count;
    return count;
  }

  /// Counts those that arrive until this time of the clock.
  int take_commands_until(double end) {
    int count = 0;
    for (double left; (left = end - clock_()) > 0; count += take_commands()) {
      check_health();
      link_->wait(std::min(left, kHealthPeriod));
    }
    return count + take_commands();
  }

  std::string command_topic() const { return ros_name(options_, options_.command); }

  void check_silence() {
    if (clock_() - last_command_time_ >= options_.deadline)
      fail<MethodTimeout>("no command on " + command_topic() + " within " +
                          format_number(options_.deadline) + " s of wall-clock time");
  }

  /// The message about too many nodes that publish commands; "" if there is none.
  std::string excess_of(const std::vector<std::string>& nodes) const {
    if (static_cast<int>(nodes.size()) <= options_.publishers) return "";
    return command_topic() + " has " + std::to_string(nodes.size()) + " publishers (" +
           join(nodes, ", ") + "), more than publishers = " + std::to_string(options_.publishers);
  }

  /// Returns their number.
  std::size_t check_publishers() {
    const std::vector<std::string> nodes = link_->publishers();
    if (const std::string excess = excess_of(nodes); !excess.empty()) fail<MethodError>(excess);
    return nodes.size();
  }

  void check_health() {
    if (process_) {
      if (const auto end = process_->exit_description())
        fail<MethodError>("the launched process ended (" + *end + ")");
    }
    if (!connected_) return;
    if (check_publishers() == 0) fail<MethodError>("no node publishes " + command_topic());
  }

  template <typename Failure>
  [[noreturn]] void fail(const std::string& reason) {
    stop();
    throw Failure(reason);
  }

  /// The next run starts new nodes.
  void stop() {
    connected_ = served_ = false;
    if (process_) {
      // Errors of nodes that end are not the reason of anything.
      std::fputs(kEndingOutput, stderr);
      process_.reset();
      std::fputs(kEndedOutput, stderr);
    }
    if (options_.launch.empty()) return;
    link_.reset();
    last_ = 0;  // which is before the first time of all new nodes
  }

  Ros2Options options_;
  std::vector<std::string> barrier_;
  std::vector<NodeParameter> parameters_;
  std::optional<ScratchFolder> folder_;  ///< with the file of parameters
  RobotModel robot_;
  SensorModel sensor_;
  EnvironmentVariables environment_;
  WallClock clock_;
  MakeLink make_link_;
  std::unique_ptr<RosLink> link_;
  std::unique_ptr<ExternalProcess> process_;  ///< ends before the link
  OptionLocation where_;
  RosTime last_;  ///< of /clock
  RosTime start_ = 0, scan_time_ = 0;
  bool connected_ = false, rested_ = false;
  bool served_ = false;                      ///< a run since the nodes were launched
  bool answered_ = false, counted_ = false;  ///< since these nodes were found
  int unanswered_ = 0;                       ///< observations since these nodes were found
  double longest_answer_ = 0;                ///< s, in this rest
  double first_sent_ = 0;                    ///< s, the first of these
  double period_ = 0, next_cycle_ = 0, next_resting_ = 0, last_command_time_ = 0;  ///< s
  Command command_;
  mrpt::math::TPose2D goal_;
  std::map<std::string, double> figures_;
};

/// The library that links DDS, loaded once. It is never unloaded: destructors of the threads of DDS
/// outlive the last link.
RosLinkFactory load_runtime(const OptionLocation& where) {
  static std::unique_ptr<SharedLibrary> library;
  std::string reason = "no slalom_ros2_make_link()";
  const std::string path = resolve_plugin_path(kRuntime, "", where("adapter"));
  if (!library) library = load_shared_library(path, reason);
  using MakeLink = RosLink* (*)(const Ros2Options&, int, const SensorModel&);
  const auto make =
      library ? reinterpret_cast<MakeLink>(library->find("slalom_ros2_make_link")) : nullptr;
  if (make == nullptr)
    throw usage_error(where("adapter"), path + " cannot be loaded: " + reason,
                      "Cyclone DDS of the distribution (libddsc)");
  return [make](const Ros2Options& options, int domain, const SensorModel& sensor) {
    return std::unique_ptr<RosLink>(make(options, domain, sensor));
  };
}

bool is_ros_name(const std::string& name) {
  const bool plain = !name.empty() && name.find("//") == std::string::npos && name.back() != '/' &&
                     name.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyz0123456789_/"
                         "ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos;
  for (std::size_t i = 0; plain && i < name.size(); ++i)
    if ((i == 0 || name[i - 1] == '/') && name[i] >= '0' && name[i] <= '9') return false;
  return plain;
}

void check_names(const Ros2Options& o, const OptionLocation& where) {
  std::vector<std::pair<const char*, std::string>> names = {
      {"command", o.command}, {"scan", o.scan},           {"odometry", o.odometry},
      {"goal", o.goal},       {"map_topic", o.map_topic}, {"tf", o.tf}};
  if (!o.name_space.empty()) names.emplace_back("namespace", o.name_space);
  for (const std::string& node : split(o.barrier, ',')) names.emplace_back("barrier", node);
  try {
    for (const NodeParameter& one : node_parameters(o))
      names.emplace_back("parameter_set", one.node);
  } catch (const std::invalid_argument& malformed) {
    throw usage_error(where("parameter_set"),
                      std::string("malformed assignment '") + malformed.what() + "'",
                      "NODE.NAME=VALUE; ...");
  }
  for (const auto& [key, name] : names)
    if (!is_ros_name(name))
      throw usage_error(where(key), "invalid name '" + name + "'",
                        "a name of ROS: letters, digits, '_' and '/'");
  if (o.mode == Ros2Mode::Realtime && !o.barrier.empty())
    throw usage_error(where("barrier"), "simulated time does not wait with mode = realtime",
                      "mode = lockstep, or no barrier");
  if (o.restart == Ros2Restart::Run && o.launch.empty())
    throw usage_error(where("restart"), "the nodes are not started by Slalom",
                      "a command line in launch, or restart = never");
}

/// A method in a domain that it keeps to itself.
class Ros2MethodInDomain : public Ros2Method {
 public:
  Ros2MethodInDomain(RosDomain domain, const Ros2Options& options, const RobotModel& robot,
                     const SensorModel& sensor, const WallClock& clock,
                     const RosLinkFactory& make_link, const OptionLocation& where)
      : Ros2Method(
            options, robot, sensor, domain.id(), clock,
            [=, id = domain.id()] { return make_link(options, id, sensor); }, where),
        domain_(std::move(domain)) {}

 private:
  RosDomain domain_;
};

RosDomain domain_of(const Ros2Options& options, const OptionLocation& where) {
  if (options.launch.empty()) {
    if (auto domain = RosDomain::share(options.domain)) return std::move(*domain);
    throw usage_error(where("domain"),
                      "another worker of Slalom uses domain " + std::to_string(options.domain),
                      "a domain for each, or a command line in launch");
  }
  if (auto domain = RosDomain::find_free(options.domain, kLastRosDomain)) return std::move(*domain);
  throw usage_error(where("domain"),
                    "all domains from " + std::to_string(options.domain) + " to " +
                        std::to_string(kLastRosDomain) + " are in use",
                    "a smaller number, or fewer workers");
}

MethodFactory make_factory(const Ros2Options& options, const OptionLocation& where,
                           const WallClock& clock) {
  check_names(options, where);
  return [=](const RobotModel& robot, const SensorModel& sensor) -> std::unique_ptr<Method> {
    if (options.scan_frame == options.base_frame && sensor.lasers.size() == 1)
      throw usage_error(where("scan_frame"),
                        "[laser." + sensor.lasers[0].name + "] has a pose on it",
                        "another frame than base_frame");
    auto method = std::make_unique<Ros2MethodInDomain>(domain_of(options, where), options, robot,
                                                       sensor, clock, load_runtime(where), where);
    // A run that begins with a new process and its threads would end its worker.
    method->start();
    return method;
  };
}

}  // namespace

std::unique_ptr<Method> make_ros2_method(const Ros2Options& options, const RobotModel& robot,
                                         const SensorModel& sensor, const WallClock& clock,
                                         const RosLinkFactory& make_link) {
  return std::make_unique<Ros2Method>(
      options, robot, sensor, kFirstRosDomain, clock,
      [=] { return make_link(options, kFirstRosDomain, sensor); }, location_of("ros2_method"));
}

MethodFactory ros2_method(const Ros2Options& options, const WallClock& clock) {
  check_options(options, location_of("ros2_method"));
  return make_factory(options, location_of("ros2_method"), clock);
}

MethodFactory read_ros2_method(const IniFile& ini, const std::string& section,
                               const WallClock& clock) {
  return make_factory(read_adapter_options<Ros2Options>(ini, section), location_in(ini, section),
                      clock);
}

std::optional<std::string> ros2_parameter_value(const IniFile& ini, const std::string& section,
                                                const std::string& name) {
  for (const std::string& one : split_nonempty(ini.get(section, "parameter_set").value_or(""), ';'))
    if (trim(one.substr(0, one.find('='))) == name) return trim(one.substr(one.find('=') + 1));
  return std::nullopt;
}

}  // namespace slalom
