// SPDX-License-Identifier: BSD-3-Clause
#include "make_list.h"

#include <slalom/app/import_scenarios.h>
#include <slalom/app/program.h>
#include <slalom/app/visited_options.h>
#include <slalom/core/printable.h>

#include <iostream>

namespace slalom {
namespace {

struct ImportArguments {
  ImportRequest request;
  std::string output;
  bool quiet = false;
};

void import(const ImportArguments& arguments) {
  const auto progress = make_silent_progress();
  ImportedScenarios imported = import_scenarios(arguments.request, *progress);
  for (const std::string& message : imported.messages)
    if (!arguments.quiet) std::cerr << printable_line(message) << "\n";
  write_scenarios(arguments.output, std::move(imported.scenarios), imported.notes, arguments.quiet);
}

}  // namespace

void add_import_verb(CLI::App& app) {
  static ImportArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "import",
      "Import maps (MRPT, ROS, MovingAI, images), worlds (Gazebo, Stage, mvsim, ir-sim, BARN), "
      "scenarios of Arena (.json), "
      "logs (.rawlog, bags) or scenarios (.scenario.yaml)");
  verb->add_option("files", arguments.request.files,
                   "Map files, worlds, .scenario.yaml files, .json of Arena, BARN grids or "
                   "folders, rawlogs, bags")
      ->required();
  verb->add_option("-o,--output", arguments.output, "The list to write (.scenarios)")->required();
  add_options_of(*verb, arguments.request);
  verb->add_flag("--quiet", arguments.quiet, "No messages");
  verb->callback([] { import(arguments); });
}

}  // namespace slalom
