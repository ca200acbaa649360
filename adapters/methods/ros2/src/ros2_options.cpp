// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/ros2/ros2_method.h>

namespace slalom {

void Ros2Options::visit(OptionVisitor& v) {
  v.option("launch", launch, External::Command,
           "command line that starts the nodes; empty: already running");
  v.option("mode", mode, "simulated time waits for commands, or follows the wall clock");
  v.option("barrier", barrier,
           "lockstep: nodes that must have handled the data before time goes on, comma-separated");
  v.option("parameter_set", parameter_set,
           "NODE.NAME=VALUE; ... parameters of nodes, set before the first run");
  v.option("domain", domain, "-", "ROS_DOMAIN_ID; with launch the first one of the workers",
           Range::between(kFirstRosDomain, kLastRosDomain));
  v.option("rmw", rmw, "RMW_IMPLEMENTATION of the launched nodes; empty: as it is");
  v.option("deadline", deadline, "s", "wall-clock time without a command", Range::positive());
  v.option("command_timeout", command_timeout, "s",
           "realtime: wall-clock time without a command after which the robot stops; 0: never",
           Range::at_least(0));
  v.option("startup_time", startup_time, "s",
           "wall-clock time until the nodes are there, and then until the first command",
           Range::positive());
  v.option("patience", patience, "s",
           "lockstep: wall-clock time for a command, then the last one is kept; 0: the deadline",
           Range::at_least(0));
  v.option("commands_per_cycle", commands_per_cycle, "-",
           "lockstep: commands that follow an observation; the last one counts",
           Range::between(1, 1000));
  v.option("clock_step", clock_step, "s",
           "lockstep: simulated time between messages of /clock; 0: a control period",
           Range::at_least(0));
  v.option(
      "restart", restart,
      "end the launched nodes and launch them again: after a failure only, or before each run");
  v.option("map", map, "publish the map of static obstacles");
  v.option("publishers", publishers, "-", "nodes that publish commands, at most",
           Range::between(1, 100));
  v.option("namespace", name_space, "namespace of names that do not begin with '/'");
  v.option("command", command, "topic of commands, Twist or TwistStamped");
  v.option("scan", scan, "topic of scans; of each of several lasers: followed by _ and its name");
  v.option("odometry", odometry, "topic of odometry");
  v.option("goal", goal, "topic of the goal");
  v.option("map_topic", map_topic, "topic of the map");
  v.option("tf", tf, "topic of transforms; static ones are on the topic NAME_static");
  v.option("base_frame", base_frame, "frame of the robot");
  v.option("scan_frame", scan_frame,
           "frame of scans; of each of several lasers: followed by _ and its name");
  v.option("odometry_frame", odometry_frame, "frame of odometry");
  v.option("map_frame", map_frame, "frame of the map and the goal");
}

}  // namespace slalom
