// SPDX-License-Identifier: BSD-3-Clause
#include "filter.h"

#include <slalom/app/checks.h>
#include <slalom/commands/edit_movers.h>
#include <slalom/commands/recorded_people.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/movers_file.h>

#include <iostream>

namespace slalom {
namespace {

struct EditArguments {
  FilterArguments filter;
  std::string add, remove, name;
};

void tag(const EditArguments& arguments) {
  if (arguments.add.empty() && arguments.remove.empty())
    throw usage_error("tag", "no tags specified", "--add A,B or --remove C");
  ScenarioList list = ScenarioList::open(arguments.filter.list.list);
  const ListSelection selection = select_scenarios(list, arguments.filter);
  make_tag_scenarios(list, selection, split(arguments.add, ','), split(arguments.remove, ','))
      ->execute();
}

void rename(const EditArguments& arguments) {
  const ListArguments& one = arguments.filter.list;
  ScenarioList list = ScenarioList::open(one.list);
  make_rename_scenario(list, list.find_entry(one.id).hash, arguments.name)->execute();
}

struct MoversArguments {
  ListArguments one;
  std::string file;
  bool remove = false, react = false;
  MoversFileOptions options;
};

/// The scenario with people in place of its moving obstacles and people.
Scenario with_reacting(const Scenario& scenario, const Movers& movers, double resolution) {
  const Scenario alone = with_movers_edited(scenario, {}).with_people({});
  if (movers.empty()) return alone;
  People people = recorded_people(World(alone, resolution), movers);
  if (const std::size_t out = movers.size() - people.size(); out > 0)
    std::cerr << "left out: " << out << " of " << movers.size()
              << ", who are never in the bounds of " << scenario.name() << "\n";
  return alone.with_people(std::move(people));
}

void set_movers(const MoversArguments& arguments) {
  if (arguments.file.empty() && !arguments.remove)
    throw usage_error("movers", "no file specified", "a file, or --remove");
  ScenarioList list = ScenarioList::open(arguments.one.list);
  const std::string hash = list.find_entry(arguments.one.id).hash;
  Movers movers;
  if (!arguments.remove) movers = load_movers_file(arguments.file, arguments.options);
  const Scenario scenario = list.read(hash);
  make_edit_scenario(list, hash,
                     arguments.react ? with_reacting(scenario, movers, arguments.one.resolution)
                                     : with_movers_edited(scenario, movers))
      ->execute();
}

void add_movers_verb(CLI::App& app) {
  static MoversArguments arguments;
  CLI::App* verb = add_list_verb(
      app, "movers", "Replace the moving obstacles of a scenario by those of a file, or its people",
      arguments.one);
  add_scenario_argument(*verb, arguments.one);
  CLI::Option* file = verb->add_option(
      "file", arguments.file,
      "CSV with the columns id, t (or frame), x, y and optionally r, lines of frame id x y, an "
      "obsmat.txt (ETH, UCY), or an agents.yaml (HuNavSim)");
  verb->add_flag("--remove", arguments.remove, "Remove all instead")->excludes(file);
  verb->add_option("--radius", arguments.options.radius, "Radius without a column r, m")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_option("--begin", arguments.options.begin, "Time in the file at which runs begin, s")
      ->capture_default_str();
  verb->add_option("--frame-rate", arguments.options.frame_rate,
                   "Frames per second of the recording; required for files with frames")
      ->check(above_zero());
  verb->add_flag("--react", arguments.react,
                 "Make people of them, in place of the moving obstacles and the people of the "
                 "scenario: they start when and where they were recorded and walk to their last "
                 "positions, but react to each other, to walls and to the robot, so that a run is "
                 "not the recording");
  verb->add_option("--resolution", arguments.one.resolution,
                   "With --react: cell size of the walls in which nobody may start, for scenarios "
                   "that are not grids, m")
      ->check(above_zero())
      ->capture_default_str();
  verb->callback([] { set_movers(arguments); });
}

}  // namespace

void add_edit_verbs(CLI::App& app) {
  static EditArguments tagged, renamed;
  CLI::App* verb = add_filter_verb(app, "tag", "Add and remove tags", tagged.filter);
  verb->add_option("--add", tagged.add, "Tags, comma-separated");
  verb->add_option("--remove", tagged.remove, "Tags, comma-separated");
  verb->callback([] { tag(tagged); });

  verb = add_list_verb(app, "rename", "Rename a scenario", renamed.filter.list);
  add_scenario_argument(*verb, renamed.filter.list);
  verb->add_option("--name", renamed.name, "The new name")->required();
  verb->callback([] { rename(renamed); });

  add_movers_verb(app);
}

}  // namespace slalom
