#include "services.h"

#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/gui/display.h>
#include <slalom/gui/making_actions.h>
#include <slalom/gui/studio_actions.h>
#include <slalom/io/result_file.h>

#include <cstdlib>
#include <iostream>

namespace slalom {
namespace {

struct StudioArguments {
  std::vector<std::string> lists;
  std::string results, config, script, settings;
  std::vector<std::string> assignments;
};

std::string default_settings_file() {
  const char* folder = std::getenv("XDG_CONFIG_HOME");
  if (folder != nullptr && *folder != '\0') return std::string(folder) + "/slalom/studio.ini";
  const char* home = std::getenv("HOME");
  return home == nullptr ? "" : std::string(home) + "/.config/slalom/studio.ini";
}

/// Scripts find the same window everywhere: they remember nothing unless they are told where.
std::string settings_file(const StudioArguments& arguments) {
  if (!arguments.settings.empty() || !arguments.script.empty()) return arguments.settings;
  return default_settings_file();
}

SceneSettings scene_settings(const StudioArguments& arguments) {
  IniFile ini =
      arguments.config.empty() ? IniFile::from_text("", "--set") : IniFile::load(arguments.config);
  for (const std::string& assignment : arguments.assignments) ini.override_key(assignment);
  SceneSettings settings;
  settings.robot = read_robot_model(ini);
  settings.sensor = read_options<SensorModel>(ini, "sensor");
  return settings;
}

/// Settings that cannot be used are told, not fatal: the window is how they are mended.
StudioSettings remembered(const std::string& file, std::string& complaint) {
  if (file.empty()) return {};
  try {
    return read_studio_settings(file);
  } catch (const Error& error) {
    complaint = error.what();
    return {};
  }
}

void add_actions(StudioWindow& window) {
  const auto services = std::make_shared<const StudioServices>(make_services());
  add_file_actions(window);
  add_exchange_actions(window, services);
  add_quit_action(window);
  add_edit_actions(window);
  add_list_actions(window);
  add_generate_actions(window, services);
  add_view_actions(window);
  add_help_actions(window);
}

void open_files(StudioWindow& window, const StudioArguments& arguments) {
  for (const std::string& list : arguments.lists) window.studio().open_list(list);
  if (!arguments.results.empty()) window.studio().results().open(arguments.results);
}

ScriptHost script_host(StudioWindow& window) {
  return {&window, [&window] { return window.studio().jobs().idle(); },
          [&window](const std::string& id) { window.run_action(id); },
          [&window](const std::string& path) { window.save_picture(path); },
          [](const std::string& text) { std::cout << text << "\n"; }};
}

void show_window(const StudioArguments& arguments) {
  std::vector<ScriptCommand> commands;
  if (!arguments.script.empty())
    commands = parse_studio_script(read_file(arguments.script), arguments.script);
  const std::string file = settings_file(arguments);
  std::string complaint;
  StudioWindow window(scene_settings(arguments), remembered(file, complaint));
  add_actions(window);
  window.finish();
  open_files(window, arguments);
  if (!complaint.empty()) window.say("The window is as it was at first: " + complaint, true);
  ScriptPlayer player(commands, arguments.script, script_host(window));
  window.run(arguments.script.empty() ? nullptr : &player);
  if (!file.empty()) write_studio_settings(window.settings(), file);
}

void define(CLI::App& app) {
  static StudioArguments arguments;
  app.add_option("lists", arguments.lists, "Scenario lists to open (.scenarios)");
  app.add_option("--results", arguments.results, "Results to lay over the scenarios (.results)");
  app.add_option("-c,--config", arguments.config,
                 "An .ini with sections [robot] and [sensor]: for whom scenarios are looked at");
  app.add_option("--set", arguments.assignments,
                 "SECTION.KEY=VALUE in place of what is in the .ini");
  app.add_option("--script", arguments.script,
                 "Plays what a user does from this file, then ends (docs/studio.md)");
  app.add_option("--settings", arguments.settings,
                 "Where the window's layout is remembered (.ini; default: "
                 "~/.config/slalom/studio.ini, with --script nowhere)");
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
