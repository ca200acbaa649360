#include "choice.h"

#include <slalom/commands/list_hash.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/png_scene.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/io/svg_scene.h>
#include <slalom/references/reference.h>

#include <iostream>

namespace slalom {
namespace {

struct PictureArguments {
  ListArguments list;
  std::string output;
  int pixels = 800;
  bool bare = false;
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

Scenario chosen(const ListArguments& arguments) {
  const ScenarioList list = ScenarioList::open(arguments.list);
  return list.read(list.find_entry(arguments.id).hash);
}

std::string contents_text(const Scenario& scenario) {
  switch (scenario.representation()) {
    case Representation::Continuous:
      return std::to_string(scenario.primitives().discs.size()) + " discs, " +
             std::to_string(scenario.primitives().polygons.size()) + " polygons";
    case Representation::Grid:
      return std::to_string(scenario.grid_map()->getSizeX()) + " x " +
             std::to_string(scenario.grid_map()->getSizeY()) + " cells of " +
             format_number(scenario.grid_map()->getResolution()) + " m";
    case Representation::Points:
      return std::to_string(scenario.point_map()->size()) + " points";
  }
  return "";
}

void show(const ListArguments& arguments) {
  const Scenario scenario = chosen(arguments);
  const Bounds& b = scenario.bounds();
  std::cout << "name            " << scenario.name() << "\nhash            " << scenario.hash()
            << "\nrepresentation  " << to_string(scenario.representation()) << " ("
            << contents_text(scenario) << ")\nbounds          x " << format_number(b.x_min)
            << " to " << format_number(b.x_max) << " m, y " << format_number(b.y_min) << " to "
            << format_number(b.y_max) << " m\nstart           " << format_number(scenario.start().x)
            << " m, " << format_number(scenario.start().y) << " m, "
            << format_number(scenario.start().phi) << " rad\ngoal            "
            << format_number(scenario.goal().x) << " m, " << format_number(scenario.goal().y)
            << " m\n";
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void render(const PictureArguments& arguments) {
  const Scenario scenario = chosen(arguments.list);
  const World world(scenario, arguments.list.resolution);
  const auto& start = scenario.start();
  References references;
  if (!arguments.bare)
    references = compute_references(
        {world, arguments.list.robot_radius, {start.x, start.y}, scenario.goal()}, nullptr, 0.01,
        1);
  SceneOptions options;
  options.max_pixels = arguments.pixels;
  options.robot_radius = arguments.list.robot_radius;
  options.references = &references;
  if (ends_with(arguments.output, ".svg")) {
    write_file_atomically(arguments.output, render_svg(scenario, options));
  } else if (ends_with(arguments.output, ".png")) {
    render_png(scenario, options, arguments.output);
  } else {
    throw usage_error("-o " + arguments.output, "is no kind of picture", ".png or .svg");
  }
}

void add_id(CLI::App& verb, ListArguments& arguments) {
  verb.add_option("--id", arguments.id, "Id, beginning of it, or name")->required();
}

}  // namespace

void add_show_verbs(CLI::App& app) {
  static EntriesArguments list;
  static ListArguments one;
  static PictureArguments picture;
  CLI::App* verb = add_list_verb(app, "list", "List ids, representations and names", list.list);
  CLI::Option* json = verb->add_flag("--json", list.list.json, "One JSON object per scenario");
  verb->add_flag("--hash", list.hash, "Only the hash of all contents, in whatever order they are")
      ->excludes(json);
  verb->callback([] { list_entries(list); });

  verb = add_list_verb(app, "show", "Show one scenario", one);
  add_id(*verb, one);
  verb->callback([] { show(one); });

  verb = add_list_verb(app, "render", "Draw one scenario with its reference paths", picture.list);
  add_id(*verb, picture.list);
  verb->add_option("-o,--output", picture.output, "A .png or .svg file")->required();
  verb->add_option("--pixels", picture.pixels, "Longer side of the picture")
      ->check(CLI::Range(16, 10000))
      ->capture_default_str();
  verb->add_flag("--bare", picture.bare, "Without reference paths");
  add_robot_options(*verb, picture.list);
  verb->callback([] { render(picture); });
}

}  // namespace slalom
