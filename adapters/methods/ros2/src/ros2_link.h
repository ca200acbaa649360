// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method.h>
#include <slalom/ros2/ros2_method.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Time of ROS, ns.
using RosTime = std::int64_t;

struct RosCommand {
  Command velocity;
  std::optional<RosTime> stamp;  ///< of a TwistStamped
};

/// A parameter of a node, with its value as text.
struct NodeParameter {
  std::string node, name, value;
};

/// A parameter is refused, or not there.
class NodeParameterError : public MethodError {
 public:
  using MethodError::MethodError;
};

/// The simulator's end of the topics of one DDS domain. Created by a library that is loaded when it
/// is needed: with DDS every program would start later.
class RosLink {
 public:
  virtual ~RosLink() = default;

  /// The counterparts that were not found yet, e.g. "a reader of /scan"; empty if all are there.
  /// Throws MethodError if one is there that does not fit.
  virtual std::vector<std::string> missing() = 0;
  /// The nodes that publish commands, each once; "a node without a name" for a participant of DDS
  /// that does not announce its nodes.
  virtual std::vector<std::string> publishers() = 0;

  /// Reads the parameter with this index and, if it has another value, sets it and reads it again,
  /// waiting up to this time (s). Returns what is still missing, e.g. "parameter speed of the node
  /// /method", or "". Throws NodeParameterError, with the node's reason, if the node refuses it.
  virtual std::string set_parameter(std::size_t parameter, double seconds) = 0;

  /// Poses in the frame of odometry, which is also that of the map.
  virtual void send_goal(const mrpt::math::TPose2D& goal, RosTime stamp) = 0;
  virtual void send_map(const KnownMap& map, RosTime stamp) = 0;
  /// Returns when the readers that are there have the map.
  virtual void await_map() = 0;
  virtual void send_transform(const Observation& observation, RosTime now) = 0;
  virtual void send_odometry(const Observation& observation, RosTime now) = 0;
  virtual void send_scans(const Observation& observation, RosTime scan_time) = 0;
  virtual void send_clock(RosTime now) = 0;

  /// Whether the node of the barrier with this index has handled all data sent so far, after
  /// waiting up to this time (s).
  virtual bool pass_barrier(std::size_t node, double seconds) = 0;

  /// The next command received.
  virtual std::optional<RosCommand> take_command() = 0;
  /// Waits for a command up to this time (s).
  virtual void wait(double seconds) = 0;
};

/// The absolute name of a topic or node.
std::string ros_name(const Ros2Options& options, const std::string& name);
/// The absolute names of the nodes of the barrier.
std::vector<std::string> barrier_nodes(const Ros2Options& options);
/// The parameters of parameter_set, with absolute names of nodes. Throws std::invalid_argument with
/// the assignment that is malformed.
std::vector<NodeParameter> node_parameters(const Ros2Options& options);
/// The same as a file of parameters of ROS 2 (YAML).
std::string parameter_file_text(const std::vector<NodeParameter>& parameters);

using RosLinkFactory =
    std::function<std::unique_ptr<RosLink>(const Ros2Options&, int domain, const SensorModel&)>;

/// The same with another link than that of DDS. `launch` is started with the domain 1.
std::unique_ptr<Method> make_ros2_method(const Ros2Options& options, const RobotModel& robot,
                                         const SensorModel& sensor, const WallClock& clock,
                                         const RosLinkFactory& make_link);

}  // namespace slalom
