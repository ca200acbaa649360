#include <slalom/commands/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/generation/generator.h>
#include <slalom/io/scenario_list.h>

#include <set>

namespace slalom {
namespace {

/// The name of a map: its file name without folders, ".gz" and the extension.
std::string map_name(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  if (file.size() > 3 && file.compare(file.size() - 3, 3, ".gz") == 0) file.resize(file.size() - 3);
  return file.substr(0, file.rfind('.'));
}

GenerationTask task_for(const SourceContext& context, int count, const std::string& name) {
  GenerationTask task;
  task.count = count;
  task.seed = derive_seed(context.seed, "scenarios/" + name);
  task.robot_radius = context.robot_radius;
  task.resolution = context.resolution;
  task.name_prefix = name;
  return task;
}

std::vector<Scenario> from_list(const std::string& path) {
  const ScenarioList list = ScenarioList::open(path);
  std::vector<Scenario> scenarios;
  for (const auto& entry : list.entries()) scenarios.push_back(list.read(entry.hash));
  return scenarios;
}

std::vector<Scenario> from_map(const std::string& path, const ScenariosSection& section,
                               const SourceContext& context, const MapLoader& load_map) {
  const Scenario map = map_scenario(path, load_map(path));
  return draw_tasks(map, task_for(context, section.pairs_per_map, map.name()),
                    section.min_distance);
}

std::vector<Scenario> from_generator(const IniFile& ini, const ScenariosSection& section,
                                     const SourceContext& context, Progress& progress) {
  const auto generator = make_generator(section.generator, ini);
  return generate_solvable(*generator, task_for(context, section.count, section.generator),
                           progress);
}

/// Keeps the order and the first of equal contents.
class DistinctScenarios {
 public:
  void add(std::vector<Scenario> scenarios) {
    for (Scenario& scenario : scenarios)
      if (hashes_.insert(scenario.hash()).second) scenarios_.push_back(std::move(scenario));
  }
  std::vector<Scenario> take() { return std::move(scenarios_); }

 private:
  std::set<std::string> hashes_;
  std::vector<Scenario> scenarios_;
};

}  // namespace

Scenario map_scenario(const std::string& path, const mrpt::maps::COccupancyGridMap2D& grid) {
  const mrpt::math::TPoint2D corner(grid.getXMin(), grid.getYMin());
  return Scenario::grid(map_name(path), grid, {corner.x, corner.y, 0}, corner);
}

void ScenariosSection::visit(OptionVisitor& v) {
  v.option("list", list, "a scenario list (.scenarios)");
  v.option("maps", maps, "map files, comma separated: MRPT gridmap or simplemap, ROS map YAML");
  v.option("pairs_per_map", pairs_per_map, "-", "start and goal pairs drawn on each map",
           Range::between(1, 1e6));
  v.option("min_distance", min_distance, "m", "straight distance from start to goal on a map",
           Range::at_least(0));
  v.option("generator", generator, "generator whose options stand in [generator.NAME]");
  v.option("count", count, "-", "scenarios to generate", Range::between(1, 1e7));
}

std::vector<Scenario> collect_scenarios(const IniFile& ini, const SourceContext& context,
                                        const MapLoader& load_map, Progress& progress) {
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  if (section.list.empty() && section.maps.empty() && section.generator.empty())
    throw usage_error(ini.where("scenarios"), "names no scenarios", "list, maps or generator");
  DistinctScenarios distinct;
  if (!section.list.empty()) distinct.add(from_list(section.list));
  for (const std::string& path : split(section.maps, ','))
    distinct.add(from_map(path, section, context, load_map));
  if (!section.generator.empty()) distinct.add(from_generator(ini, section, context, progress));
  return distinct.take();
}

}  // namespace slalom
