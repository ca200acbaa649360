// SPDX-License-Identifier: BSD-3-Clause
#include "filter.h"

#include <slalom/app/checks.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/io/list_hash.h>
#include <slalom/io/png_scene.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/io/svg_scene.h>
#include <slalom/references/reference.h>

#include <iostream>

namespace slalom {
namespace {

struct RenderArguments {
  ListArguments list;
  std::string output;
  int pixels = 800;
};

struct EntriesArguments {
  ListArguments list;
  bool hash = false;
};

void list_entries(const EntriesArguments& arguments) {
  const ScenarioList list = ScenarioList::open(arguments.list.list);
  if (arguments.hash) {
    std::cout << content_hash(list) << "\n";
    return;
  }
  list.for_each({}, [&](const ScenarioList::Entry& entry) {
    print_entry(entry, arguments.list.json);
    return true;
  });
}

std::string contents_text(const Scenario& scenario) {
  if (scenario.representation() == Representation::Continuous) {
    const Primitives& obstacles = scenario.primitives();
    return count_text(obstacles.discs.size(), "disc") + ", " +
           count_text(obstacles.polygons.size(), "polygon");
  }
  if (scenario.representation() == Representation::Points)
    return count_text(scenario.point_map()->size(), "point");
  const auto& map = *scenario.grid_map();
  return std::to_string(map.getSizeX()) + " x " + std::to_string(map.getSizeY()) + " cells of " +
         format_number(map.getResolution()) + " m";
}

void show(const ListArguments& arguments) {
  const Scenario scenario = load_scenario(arguments);
  const Bounds& b = scenario.bounds();
  const auto& start = scenario.start();
  constexpr auto number = format_number;
  std::cout << "name            " << printable_line(scenario.name()) << "\nhash            "
            << scenario.hash() << "\nrepresentation  " << to_string(scenario.representation())
            << " (" << contents_text(scenario) << ")\nbounds          x " << number(b.x_min)
            << " to " << number(b.x_max) << " m, y " << number(b.y_min) << " to " << number(b.y_max)
            << " m\nstart           " << number(start.x) << " m, " << number(start.y) << " m, "
            << number(start.phi) << " rad\ngoal            " << number(scenario.goal().x) << " m, "
            << number(scenario.goal().y) << " m\n";
  if (!scenario.movers().empty())
    std::cout << "movers          " << scenario.movers().size() << "\n";
  if (!scenario.people().empty())
    std::cout << "people          " << scenario.people().size() << "\n";
}

void render(const RenderArguments& arguments) {
  require_picture(arguments.output);
  const Scenario scenario = load_scenario(arguments.list);
  const World world(scenario, arguments.list.resolution);
  const auto& start = scenario.start();
  const References references = compute_references(
      {world, arguments.list.robot_radius, {start.x, start.y}, scenario.goal()}, nullptr, 0.01, 1);
  write_picture(scenario, references, arguments.list.robot_radius, arguments.pixels,
                arguments.output);
}

}  // namespace

void write_picture(const Scenario& scenario, const References& references, double robot_radius,
                   int pixels, const std::string& path) {
  SceneOptions options;
  options.max_pixels = pixels;
  options.robot_radius = robot_radius;
  options.references = &references;
  if (ends_with(path, ".svg"))
    write_file_atomically(path, render_svg(scenario, options));
  else
    render_png(scenario, options, path);
}

void require_picture(const std::string& path) {
  if (!ends_with(path, ".svg") && !ends_with(path, ".png"))
    throw usage_error("-o " + path, "unknown image format", ".png or .svg");
}

void add_show_verbs(CLI::App& app) {
  static EntriesArguments list;
  static ListArguments one;
  static RenderArguments rendered;
  CLI::App* verb = add_list_verb(app, "list", "List ids, representations and names", list.list);
  CLI::Option* json = verb->add_flag("--json", list.list.json, "One JSON object per scenario");
  verb->add_flag("--hash", list.hash,
                 "Print only the hash of all contents, independent of their order")
      ->excludes(json);
  verb->callback([] { list_entries(list); });

  verb = add_list_verb(app, "show", "Show one scenario", one);
  add_scenario_argument(*verb, one);
  verb->callback([] { show(one); });

  verb = add_list_verb(app, "render", "Draw one scenario with its reference paths", rendered.list);
  add_scenario_argument(*verb, rendered.list);
  verb->add_option("-o,--output", rendered.output, "A .png or .svg file")->required();
  verb->add_option("--pixels", rendered.pixels, "Longer side of the image, pixels")
      ->check(in_range(16, 10000))
      ->capture_default_str();
  add_robot_options(*verb, rendered.list);
  verb->callback([] { render(rendered); });
}

}  // namespace slalom
