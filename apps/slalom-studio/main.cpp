// SPDX-License-Identifier: BSD-3-Clause
#include "services.h"

#include <slalom/app/checks.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/gui/panel_window.h>
#include <slalom/gui/studio_window.h>
#include <slalom/io/result_file.h>
#include <slalom/results/recorded_ini.h>
#include <slalom/ros_parameters/resolve.h>
#include <slalom/simulation/simulate.h>

#include <algorithm>
#include <cstdlib>

namespace slalom {
namespace {

struct StudioArguments {
  std::vector<std::string> lists;
  double scale = 0;  ///< 0: as in the settings
  std::string results, config, script, settings;
  std::vector<std::string> assignments;
};

std::string default_settings_file() {
  const char* folder = std::getenv("XDG_CONFIG_HOME");
  if (folder != nullptr && *folder != '\0') return std::string(folder) + "/slalom/studio.ini";
  const char* home = std::getenv("HOME");
  return home == nullptr ? "" : std::string(home) + "/.config/slalom/studio.ini";
}

/// Scripts do not use the settings of the user, so that the window is the same everywhere.
std::string settings_file(const StudioArguments& arguments) {
  if (!arguments.settings.empty() || !arguments.script.empty()) return arguments.settings;
  return default_settings_file();
}

/// Robot and sensor: of the configuration, else of the results.
IniFile base_ini(const StudioArguments& arguments) {
  if (!arguments.config.empty()) return IniFile::load(arguments.config);
  if (!arguments.results.empty())
    return recorded_ini(ResultFile::open(arguments.results).read_manifest(),
                        arguments.results + ": campaign.ini");
  return IniFile::from_text("", "--set");
}

/// The .ini if it has methods; it may describe only the robot and the sensor.
std::string campaign_with_methods(const std::string& config) {
  if (config.empty()) return "";
  const std::vector<std::string> sections = IniFile::load(config).sections();
  return std::any_of(sections.begin(), sections.end(),
                     [](const std::string& name) { return starts_with(name, "method."); })
             ? config
             : "";
}

SceneSettings scene_settings(const StudioArguments& arguments) {
  IniFile ini = base_ini(arguments);
  for (const std::string& assignment : arguments.assignments) ini.override_key(assignment);
  resolve_ros_parameters(ini);
  SceneSettings settings;
  settings.robot = read_robot_model(ini);
  settings.sensor = read_sensor_model(ini);
  settings.resolution = read_options<SimulationOptions>(ini, "simulation").resolution;
  return settings;
}

/// Reads the settings. Returns the defaults and sets `warning` on an error.
StudioSettings read_settings(const std::string& file, std::string& warning) {
  if (file.empty()) return {};
  try {
    return read_studio_settings(file);
  } catch (const Error& error) {
    warning = error.what();
    return {};
  }
}

void open_files(StudioWindow& window, const StudioArguments& arguments) {
  for (const std::string& list : arguments.lists) window.studio().open_list(list);
  if (!arguments.results.empty()) window.studio().results().open(arguments.results);
}

void show_window(const StudioArguments& arguments) {
  std::vector<ScriptCommand> commands;
  if (!arguments.script.empty())
    commands = parse_studio_script(read_text(arguments.script, "a script", kMaxConfigSize),
                                   arguments.script);
  const std::string file = settings_file(arguments);
  std::string warning;
  StudioSettings settings = read_settings(file, warning);
  if (arguments.scale > 0) settings.scale = arguments.scale;
  // Scripts do not depend on the desktop.
  if (settings.scale == 0 && !arguments.script.empty()) settings.scale = 1;
  StudioWindow window(
      scene_settings(arguments), settings,
      make_services(campaign_with_methods(arguments.config), arguments.assignments));
  open_files(window, arguments);
  if (!warning.empty())
    window.studio().events().show_status("The default layout is used: " + warning, true);
  arguments.script.empty() ? window.run() : window.run(commands, arguments.script);
  if (!file.empty()) write_studio_settings(window.settings(), file);
}

void define(CLI::App& app) {
  static StudioArguments arguments;
  app.add_option("lists", arguments.lists, "Scenario lists to open (.scenarios)");
  app.add_option("--results", arguments.results,
                 "Results to show on top of the scenarios (.results)");
  app.add_option(
      "-c,--config", arguments.config,
      "An .ini with the robot and the sensor: sections [robot], [sensor] (default: those of the "
      "results); its methods, if any, are those of 'Run methods here'");
  app.add_option("--set", arguments.assignments, "Override a key of the .ini: SECTION.KEY=VALUE");
  app.add_option("--scale", arguments.scale,
                 "Screen pixels per pixel of the window, to enlarge texts and all else (default: "
                 "that of the desktop; 1 with --script)")
      ->check(in_range(kMinScale, kMaxScale));
  app.add_option("--script", arguments.script,
                 "Plays the user input of a script file, then exits (docs/guide/studio.md)");
  app.add_option("--settings", arguments.settings,
                 "File of the window layout and recent files (.ini; default: "
                 "~/.config/slalom/studio.ini, none with --script)");
  app.callback([] {
    with_display("window", "xvfb-run -a slalom-studio --script FILE",
                 [] { show_window(arguments); });
  });
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  return slalom::run_program("slalom-studio", "Shows and edits scenario lists in a window.", argc,
                             argv, slalom::define, false);
}
