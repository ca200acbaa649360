// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/checks.h>
#include <slalom/app/program.h>

namespace slalom {

CLI::App* add_list_verb(CLI::App& app, const std::string& name, const std::string& help,
                        ListArguments& arguments) {
  CLI::App* verb = app.add_subcommand(name, help);
  verb->add_option("list", arguments.list, "A scenario list (.scenarios)")->required();
  return verb;
}

void add_scenario_argument(CLI::App& verb, ListArguments& arguments, bool required) {
  add_argument(
      verb,
      {"scenario", "--id",
       std::string(required ? "A" : "Only this") + " scenario: id, prefix of the id, or name",
       required},
      arguments.id);
}

void add_robot_options(CLI::App& verb, ListArguments& arguments) {
  verb.add_option("--robot-radius", arguments.robot_radius, "Radius of the robot, m")
      ->check(above_zero())
      ->capture_default_str();
  verb.add_option("--resolution", arguments.resolution,
                  "Cell size for scenarios that are not grids, m")
      ->check(above_zero())
      ->capture_default_str();
}

}  // namespace slalom

int main(int argc, char** argv) {
  return slalom::run_program("slalom-scenarios",
                             "Generates, imports, describes and manages scenarios.", argc, argv,
                             [](CLI::App& app) {
                               slalom::add_creation_verbs(app);
                               slalom::add_describe_verb(app);
                               slalom::add_show_verbs(app);
                               slalom::add_select_verbs(app);
                               slalom::add_lists_verbs(app);
                               slalom::add_edit_verbs(app);
                               slalom::add_index_verbs(app);
                               slalom::add_convert_verbs(app);
                               slalom::add_reference_verb(app);
                             });
}
