#include <slalom/core/error.h>
#include <slalom/lcm/lcm_method.h>

namespace slalom {
namespace {

/// LCM's channel names have at most 63 characters; the rest is for the instance and the message.
constexpr std::size_t kMaxChannel = 24;

}  // namespace

void LcmOptions::visit(OptionVisitor& v) {
  std::string adapter = "lcm";
  v.option("adapter", adapter, "the adapter that this method comes in by", {"lcm"});
  v.option("url", url, "LCM provider and its address");
  v.option("channel", channel, "first part of the channels' names");
  v.option("launch", launch, "command line that starts the process; empty: it runs already");
  v.option("deadline", deadline, "s", "wall-clock time for an answer", Range::positive());
  v.option("startup_time", startup_time, "s", "wall-clock time to start and answer",
           Range::positive());
  v.option("mode", mode, "simulated time waits for answers, or runs with the wall clock",
           {"lockstep", "realtime"});
}

LcmOptions read_lcm_options(const IniFile& ini, const std::string& section) {
  LcmOptions options;
  OptionReader reader(ini, section);
  options.visit(reader);
  if (options.channel.empty() || options.channel.size() > kMaxChannel)
    throw usage_error(ini.where(section, "channel"), "'" + options.channel + "' is no channel",
                      "1 to " + std::to_string(kMaxChannel) + " characters");
  return options;
}

std::map<std::string, std::string> own_settings(const IniFile& ini, const std::string& section) {
  OptionReader reader(ini, section);
  LcmOptions().visit(reader);
  std::map<std::string, std::string> settings;
  for (const std::string& key : ini.keys(section)) settings[key] = *ini.get(section, key);
  for (const std::string& key : reader.known_keys()) settings.erase(key);
  return settings;
}

}  // namespace slalom
