// SPDX-License-Identifier: BSD-3-Clause
#include "bag_options.h"

#include <iostream>

namespace slalom {

void add_bag_options(CLI::App& verb, BagSelection& selection) {
  verb.add_option("--scan", selection.scan,
                  "Topic of a bag with LaserScan (default: the only one, as of the others)");
  verb.add_option("--odom", selection.odometry,
                  "Topic of a bag with Odometry; without one, the transform from odom");
  verb.add_option("--command", selection.command, "Topic of a bag with Twist or TwistStamped");
  verb.add_option("--base", selection.base,
                  "Frame of the robot's center in a bag (default: base_link)");
}

void print_notes(const LogObjects& log) {
  for (const std::string& note : log.notes) std::cerr << log.path << ": " << note << "\n";
}

}  // namespace slalom
