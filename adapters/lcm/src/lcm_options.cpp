#include <slalom/lcm/lcm_method.h>

namespace slalom {

void LcmOptions::visit(OptionVisitor& v) {
  std::string adapter = "lcm";
  v.option("adapter", adapter, "adapter of this method", {"lcm"});
  v.option("url", url, "LCM provider URL");
  v.option("channel", channel, "prefix of the channel names");
  v.option("launch", launch, "command line that starts the process; empty: already running");
  v.option("deadline", deadline, "s", "wall-clock time for a reply", Range::positive());
  v.option("startup_time", startup_time, "s", "wall-clock time to start and reply",
           Range::positive());
  v.option("mode", mode, "simulated time waits for replies, or follows the wall clock");
}

}  // namespace slalom
