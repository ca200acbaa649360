// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/completion.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/lcm/lcm_method.h>
#include <slalom/lcm/method_host.h>
#include <slalom/library/library_method.h>

#include <csignal>
#include <iostream>

namespace slalom {
namespace {

constexpr char kSection[] = "method.plugin";

volatile std::sig_atomic_t stop_requested = 0;

struct HostArguments {
  std::string plugin;
  std::vector<std::string> settings;
  std::string url = kLcmUrl;
  std::string channel = LcmOptions().channel;
  std::string replay;
  bool quiet = false;
};

/// The configuration of the plug-in as a section of an .ini.
IniFile configuration(const HostArguments& arguments) {
  IniFile ini = IniFile::from_text("", "slalom-lcm-method");
  ini.set(kSection, "adapter", "library");
  ini.set(kSection, "plugin", arguments.plugin);
  for (const std::string& setting : arguments.settings)
    ini.override_key(std::string(kSection) + "." + setting);
  ini.set(kSection, "plugin", resolve_plugin_path(ini, kSection, "plugin"));
  return ini;
}

/// Settings from the simulator override --set.
MethodHost make_host(const IniFile& ini) {
  return MethodHost("slalom-lcm-method", [ini](const hello_t& hello) {
    IniFile own = ini;
    for (const auto& [key, value] : settings_of(hello)) own.set(kSection, key, value);
    return read_library_method(own, kSection)(robot_of(hello), sensor_of(hello));
  });
}

void serve(const HostArguments& arguments, const IniFile& ini) {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { stop_requested = 1; });
  MethodHost host = make_host(ini);
  if (!arguments.quiet)
    std::cerr << "Listening on " << arguments.channel << "_HELLO at " << arguments.url << "\n";
  serve_method(host, arguments.url, arguments.channel, [] { return stop_requested != 0; });
}

void replay(const HostArguments& arguments, const IniFile& ini) {
  const LogReplay found = replay_log(arguments.replay, [&ini] { return make_host(ini); });
  std::cout << found.runs << " runs, " << found.observations << " observations, " << found.commands
            << " commands, " << found.different << " different\n";
  if (found.different > 0)
    throw job_error(arguments.replay,
                    "different answer of the method at " + found.first_difference);
}

void define(CLI::App& app) {
  static HostArguments arguments;
  complete_with(app.add_option("-p,--plugin", arguments.plugin,
                               "Shared library of the method (see slalom_method.h)")
                    ->required(),
                [](const Words&) { return shipped_plugins(); });
  app.add_option("--set", arguments.settings, "Parameter of the method: KEY=VALUE")
      ->allow_extra_args(false);
  app.add_option("--url", arguments.url, "LCM provider URL")
      ->envname("SLALOM_LCM_URL")
      ->capture_default_str();
  app.add_option("--channel", arguments.channel, "Prefix of the channel names")
      ->envname("SLALOM_LCM_CHANNEL")
      ->capture_default_str();
  app.add_option("--replay", arguments.replay,
                 "Replay a log of lcm-logger and compare the commands, instead of serving");
  app.add_flag("--quiet", arguments.quiet, "No messages except errors");
  app.callback([] {
    const IniFile ini = configuration(arguments);
    arguments.replay.empty() ? serve(arguments, ini) : replay(arguments, ini);
  });
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  return slalom::run_program("slalom-lcm-method",
                             "Hosts a compiled method as an external process over LCM.", argc, argv,
                             slalom::define);
}
