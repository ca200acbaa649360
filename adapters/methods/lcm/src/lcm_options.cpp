// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/lcm/lcm_method.h>

namespace slalom {

void LcmOptions::visit(OptionVisitor& v) {
  v.option("url", url, External::Address,
           "LCM provider URL; empty: " + std::string(kLcmUrl) +
               ", for a launched process with a port of its own");
  v.option("channel", channel, External::Address, "prefix of the channel names");
  v.option("launch", launch, External::Command,
           "command line that starts the process; empty: already running");
  v.option("deadline", deadline, "s", "wall-clock time for a reply", Range::positive());
  v.option("startup_time", startup_time, "s", "wall-clock time to start and reply",
           Range::positive());
  v.option("mode", mode, "simulated time waits for replies, or follows the wall clock");
}

}  // namespace slalom
