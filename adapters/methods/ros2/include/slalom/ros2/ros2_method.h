// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/core/wall_clock.h>
#include <slalom/methods/method_factory.h>

#include <optional>
#include <string>

namespace slalom {

/// Simulated time waits for each command, or follows the wall clock.
enum class Ros2Mode { Lockstep, Realtime };
constexpr auto enum_names(Ros2Mode) {
  return std::array{"lockstep", "realtime"};
}

/// The contents of the map's topic: nothing, or the static obstacles of the scenario.
enum class Ros2Map { None, Known };
constexpr auto enum_names(Ros2Map) {
  return std::array{"none", "known"};
}

/// The occasions on which launched nodes are launched again: a failure only, or each run, too.
enum class Ros2Restart { Never, Run };
constexpr auto enum_names(Ros2Restart) {
  return std::array{"never", "run"};
}

/// The domains that ROS 2 can use beside all ports that Linux gives to programs. Domain 0 is that
/// of real robots, which would move.
constexpr int kFirstRosDomain = 1, kLastRosDomain = 101;

/// A method of the adapter ros2.
struct Ros2Options {
  std::string launch;  ///< command line that starts the nodes; empty: already running
  Ros2Mode mode = Ros2Mode::Lockstep;
  /// Nodes that must have handled the data before time goes on, in this order, comma-separated.
  std::string barrier;
  /// Parameters of nodes, "NODE.NAME=VALUE; ...", set and read back before the first run.
  std::string parameter_set;
  int domain = 42;               ///< DDS domain; with `launch` the first one of the workers
  std::string rmw;               ///< RMW_IMPLEMENTATION of the launched nodes; empty: unchanged
  double deadline = 10;          ///< wall-clock time without a command, s
  double command_timeout = 0.5;  ///< realtime: without a command the robot stops after, s; 0: never
  double startup_time = 30;      ///< wall-clock time until the first command, s
  double patience = 0;           ///< lockstep: wall-clock time for a command, s; 0: the deadline
  int commands_per_cycle = 1;  ///< lockstep: commands for an observation, of which the last counts
  double clock_step = 0;       ///< simulated time between clock messages, s; 0: a control period
  Ros2Restart restart = Ros2Restart::Never;
  Ros2Map map = Ros2Map::None;
  int publishers = 1;  ///< nodes that publish commands, at most

  std::string name_space;  ///< of topics and nodes whose names do not begin with '/'
  std::string command = "cmd_vel", scan = "scan", odometry = "odom", goal = "goal_pose";
  std::string map_topic = "map", tf = "/tf";
  std::string base_frame = "base_link", scan_frame = "laser", odometry_frame = "odom";
  std::string map_frame = "map";

  void visit(OptionVisitor& v);
};

/// A method that is a ROS 2 node, or several, reached over DDS without an installation of ROS.
///
/// It is given /scan, /odom, /tf, /tf_static, /clock, the goal as PoseStamped and, if declared, the
/// map; it answers with Twist or TwistStamped. In lock-step step() sends the data, waits until the
/// nodes of `barrier` have handled them, then advances the clock and waits for one command: the
/// results of nodes whose commands follow from messages and timers in simulated time are
/// repeatable. In real time step() returns the latest command at the end of its control period of
/// the wall clock.
///
/// settle() gives nodes that start the data of a robot that rests, then the goal; the robot stands
/// at its start for at least 1 s of simulated time, until the nodes have answered each observation
/// of a second, or in real time once. For nodes that run simulated time never goes back. In real
/// time the robot stops after command_timeout without a command. Velocities beyond the robot's
/// limits become the nearest ones within them, as on a real base.
///
/// settle() and step() throw MethodTimeout when no command arrives in time, and MethodError when
/// the process exits, the publishers of the commands are not as expected, or a node refuses a
/// parameter. check() throws Error (Usage) when the launched nodes do not appear within the startup
/// time, or refuse a parameter.
MethodFactory ros2_method(const Ros2Options& options, const WallClock& clock = steady_seconds);

/// The same with options from an .ini; a MethodReader.
MethodFactory read_ros2_method(const IniFile& ini, const std::string& section,
                               const WallClock& clock = steady_seconds);

/// The value of "NODE.NAME" in `parameter_set` of an .ini; none if it has none.
std::optional<std::string> ros2_parameter_value(const IniFile& ini, const std::string& section,
                                                const std::string& name);

}  // namespace slalom
