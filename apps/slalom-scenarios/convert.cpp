#include "verbs.h"

#include <slalom/commands/list_command.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>
#include <slalom/map_formats/map_export.h>
#include <slalom/scenario/convert.h>
#include <slalom/scenario/occupancy.h>

#include <iostream>

namespace slalom {
namespace {

struct ConvertArguments {
  ListArguments list;
  std::string to, output;
  ConversionOptions options;
  bool skip_blocked = false, quiet = false;
};

/// The place of the task that obstacles cover on cells of that size, or "".
std::string blocked_place(const Scenario& scenario, double resolution) {
  const Occupancy cells = make_occupancy(scenario, resolution);
  const auto blocked = [&cells](double x, double y) {
    const auto at = cells.to_cells({x, y});
    return cells.occupied(static_cast<int>(at.x), static_cast<int>(at.y));
  };
  if (blocked(scenario.start().x, scenario.start().y)) return "start";
  return blocked(scenario.goal().x, scenario.goal().y) ? "goal" : "";
}

/// Whether the conversion covered start or goal; throws when such are not to be skipped.
bool is_blocked(const Scenario& before, const Scenario& after, const ConvertArguments& arguments) {
  const std::string place = blocked_place(after, arguments.options.resolution);
  if (place.empty() || blocked_place(before, arguments.options.resolution) == place) return false;
  const Error error =
      job_error(before.name(), "its " + place + " would be occupied as " + arguments.to,
                "another resolution, tolerance or radius, or --skip-blocked");
  if (!arguments.skip_blocked) throw error;
  std::cerr << error.what() << ": left out\n";
  return true;
}

/// So many are converted before they are written, to keep memory small.
constexpr std::size_t kPart = 128;

/// Appends what the scenarios of `list` become; they keep their tags.
void add_converted(const ScenarioList& list, const ConvertArguments& arguments,
                   ScenarioList& output) {
  const Representation to = representation_from_string(arguments.to);
  std::vector<Scenario> part;
  std::vector<ScenarioOrigin> origins;
  const auto write_part = [&] {
    make_add_scenarios(output, std::move(part), std::move(origins))->execute();
    part.clear();
    origins.clear();
  };
  list.for_each({}, [&](const ScenarioList::Entry& entry) {
    const Scenario before = list.read(entry.hash);
    Scenario after = convert(before, to, arguments.options);
    if (is_blocked(before, after, arguments)) return true;
    part.push_back(std::move(after));
    origins.push_back({"", std::nullopt, entry.tags});
    if (part.size() == kPart) write_part();
    return true;
  });
  write_part();
}

void convert_list(const ConvertArguments& arguments) {
  const ScenarioList list = ScenarioList::open(arguments.list.list);
  std::size_t size = 0;
  ScenarioList::write(arguments.output, [&](ScenarioList& output) {
    add_converted(list, arguments, output);
    output.set_note("origin", "converted to " + arguments.to + " from " + arguments.list.list +
                                  ": resolution " + format_number(arguments.options.resolution) +
                                  " m, tolerance " + format_number(arguments.options.tolerance) +
                                  " m\n" + list.note("origin").value_or(""));
    size = output.size();
  });
  if (!arguments.quiet) std::cerr << arguments.output << ": " << size << " scenarios\n";
}

struct ExportArguments {
  ListArguments list;
  std::string format = "yaml", output;
  MapExportOptions options;
};

void export_one(const ExportArguments& arguments) {
  const ScenarioList list = ScenarioList::open(arguments.list.list);
  export_scenario(list.read(list.find_entry(arguments.list.id).hash), arguments.format,
                  arguments.options, arguments.output);
}

void add_convert(CLI::App& app) {
  static ConvertArguments arguments;
  CLI::App* verb = add_list_verb(
      app, "convert", "Make every scenario one of another representation", arguments.list);
  verb->add_option("--to", arguments.to, "continuous, grid or points")
      ->check(CLI::IsMember({"continuous", "grid", "points"}))
      ->required();
  verb->add_option("--resolution", arguments.options.resolution,
                   "Cells of grids, spacing of points on boundaries, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_option("--tolerance", arguments.options.tolerance,
                   "By how much outlines of cells may be simplified, m; 0: exact")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_option("--radius", arguments.options.point_radius,
                   "Of the discs that points become, m; 0: half the resolution")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_flag("--skip-blocked", arguments.skip_blocked,
                 "Leave scenarios out whose start or goal becomes occupied");
  verb->add_option("-o,--output", arguments.output, "The list to write (.scenarios)")->required();
  verb->add_flag("--quiet", arguments.quiet, "No count");
  verb->callback([] { convert_list(arguments); });
}

void add_export(CLI::App& app) {
  static ExportArguments arguments;
  std::vector<std::string> names, help;
  for (const ExportFormat& format : export_formats()) {
    names.push_back(format.name);
    help.push_back(format.name + " (" + format.content + ", " + format.ending + ")");
  }
  CLI::App* verb =
      add_list_verb(app, "export", "Write one scenario for another program", arguments.list);
  verb->add_option("--id", arguments.list.id, "Id, beginning of it, or name")->required();
  verb->add_option("--format", arguments.format, join(help, "; "))
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  verb->add_option("--resolution", arguments.options.resolution,
                   "Cells of maps made from other representations, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_option("-o,--output", arguments.output, "The file")->required();
  verb->callback([] { export_one(arguments); });
}

}  // namespace

void add_convert_verbs(CLI::App& app) {
  add_convert(app);
  add_export(app);
}

}  // namespace slalom
