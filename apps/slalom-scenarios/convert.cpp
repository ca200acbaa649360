// SPDX-License-Identifier: BSD-3-Clause
#include "filter.h"

#include <slalom/app/checks.h>
#include <slalom/app/program.h>
#include <slalom/commands/convert_list.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/map_export.h>

#include <iostream>

namespace slalom {
namespace {

struct ConvertArguments {
  ListArguments list;
  std::string output;
  ListConversion conversion;
  bool quiet = false;
};

void convert_verb(const ConvertArguments& arguments) {
  const ScenarioList list = ScenarioList::open(arguments.list.list);
  std::size_t size = 0;
  ScenarioList::write(arguments.output, [&](ScenarioList& output) {
    for (const std::string& message : convert_list(list, arguments.conversion, output))
      std::cerr << printable_line(message) << "\n";
    size = output.size();
  });
  if (!arguments.quiet)
    std::cerr << arguments.output << ": " << count_text(size, "scenario") << "\n";
}

struct ExportArguments {
  ListArguments list;
  std::string format = "yaml", output;
  MapExportOptions options;
};

void export_one(const ExportArguments& arguments) {
  const std::string left_out = export_scenario(load_scenario(arguments.list), arguments.format,
                                               arguments.options, arguments.output);
  if (!left_out.empty()) std::cerr << "warning: " << printable_line(left_out) << "\n";
}

void add_convert(CLI::App& app) {
  static ConvertArguments arguments;
  CLI::App* verb = add_list_verb(app, "convert", "Convert all scenarios to another representation",
                                 arguments.list);
  add_choice(*verb, "--to", arguments.conversion.to, "continuous, grid or points")->required();
  verb->add_option("--resolution", arguments.conversion.options.resolution,
                   "Cell size of grids, spacing of points on boundaries, m")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_option("--tolerance", arguments.conversion.options.tolerance,
                   "Tolerance of polygon simplification, m; 0: exact")
      ->check(not_negative())
      ->capture_default_str();
  verb->add_option("--radius", arguments.conversion.options.point_radius,
                   "Radius of discs that replace points, m; 0: half the resolution")
      ->check(not_negative())
      ->capture_default_str();
  verb->add_flag("--skip-blocked", arguments.conversion.skip_blocked,
                 "Skip scenarios whose start or goal becomes occupied");
  verb->add_option("-o,--output", arguments.output, "The list to write (.scenarios)")->required();
  verb->add_flag("--quiet", arguments.quiet, "No messages");
  verb->callback([] { convert_verb(arguments); });
}

void add_export(CLI::App& app) {
  static ExportArguments arguments;
  std::vector<std::string> names, help;
  for (const ExportFormat& format : export_formats()) {
    names.push_back(format.name);
    help.push_back(format.name + " (" + format.content + ", " + format.ending + ")");
  }
  CLI::App* verb =
      add_list_verb(app, "export", "Export one scenario for another program", arguments.list);
  add_scenario_argument(*verb, arguments.list);
  verb->add_option("--format", arguments.format, join(help, "; "))
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  verb->add_option("--resolution", arguments.options.resolution,
                   "Cell size of maps made from other representations, m")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_option("-o,--output", arguments.output, "The file to write")->required();
  verb->callback([] { export_one(arguments); });
}

}  // namespace

void add_convert_verbs(CLI::App& app) {
  add_convert(app);
  add_export(app);
}

}  // namespace slalom
