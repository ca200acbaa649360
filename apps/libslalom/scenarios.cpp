// SPDX-License-Identifier: BSD-3-Clause
#include "calls.h"
#include "scenarios.h"

#include <slalom/campaign/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/evaluate.h>
#include <slalom/io/scenario_list.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/io/svg_scene.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace slalom {
namespace {

using Json = nlohmann::json;

/// Throws Error (Usage) for null.
template <typename List>
List& list_of(List* list) {
  if (list == nullptr) throw usage_error("scenarios", "are a null pointer", "a list");
  return *list;
}

const Scenario& scenario_of(const slalom_scenarios* list, std::size_t index) {
  const std::vector<Scenario>& scenarios = list_of(list).scenarios;
  if (index >= scenarios.size())
    throw usage_error("scenario " + std::to_string(index), "is not in the list",
                      "less than " + std::to_string(scenarios.size()));
  return scenarios[index];
}

template <typename Make>
slalom_scenarios* make_list(Make make) {
  return guarded<slalom_scenarios*>(nullptr, [&] {
    return std::make_unique<slalom_scenarios>(slalom_scenarios{make()}).release();
  });
}

template <typename Describe>
char* text_about(const slalom_scenarios* list, std::size_t index, Describe describe) {
  return guarded<char*>(nullptr, [&] { return to_owned(describe(scenario_of(list, index))); });
}

std::vector<Scenario> read_list(const std::string& path) {
  if (ends_with(path, ".yaml")) return {load_scenario_yaml(path)};
  const ScenarioList list = ScenarioList::open(path);
  std::vector<Scenario> scenarios;
  for (const ScenarioList::Entry& entry : list.entries())
    scenarios.push_back(list.read(entry.hash));
  return scenarios;
}

/// Moving obstacles with the keys that they have in YAML.
Json movers_of(const Scenario& scenario) {
  Json movers = Json::array();
  for (const Mover& mover : scenario.movers()) {
    Json waypoints = Json::array();
    for (const Waypoint& w : mover.waypoints)
      waypoints.push_back({w.t, w.position.x, w.position.y});
    movers.push_back({{"id", mover.id},
                      {"radius", mover.radius},
                      {"after", to_string(mover.after)},
                      {"waypoints", waypoints}});
  }
  return movers;
}

std::string describe_scenario(const Scenario& scenario) {
  const Bounds& bounds = scenario.bounds();
  const auto heading = scenario.goal_heading();
  return Json({{"name", scenario.name()},
               {"hash", scenario.hash()},
               {"start", {scenario.start().x, scenario.start().y, scenario.start().phi}},
               {"goal", {scenario.goal().x, scenario.goal().y}},
               {"goal_heading", heading ? Json(*heading) : Json()},
               {"bounds", {bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max}},
               {"movers", movers_of(scenario)}})
      .dump();
}

/// A family whose candidates a function of the host makes.
class OwnFamily : public Generator {
 public:
  OwnFamily(std::string name, slalom_family make, void* context)
      : name_(std::move(name)), make_(make), context_(context) {
    if (make_ == nullptr) throw usage_error("family", "is a null pointer", "a function");
  }

  std::string name() const override { return name_; }
  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const std::uint64_t seed = engine();
    const Entered entered;
    const int failed = make_(context_, scenario_name.c_str(), seed);
    const std::string reply = take_reply();
    if (failed != 0) throw usage_error("family " + name_, reply);
    return scenario_from_yaml(reply, "family " + name_);
  }

 private:
  std::string name_;
  slalom_family make_;
  void* context_;
};

/// Arguments of the generation of a family.
struct Generation {
  int count;
  std::uint64_t seed;
  int workers;
  slalom_progress progress;
  void* context;
};

std::vector<Scenario> generate_family(
    const Generation& asked, const Json& settings,
    const std::function<std::shared_ptr<const Generator>(const IniFile& ini)>& make_family) {
  if (asked.count < 1 || asked.workers < 0)
    throw usage_error("generate",
                      std::to_string(asked.count) + " scenarios by " +
                          std::to_string(asked.workers) + " threads cannot be made",
                      "at least 1 by 0 or more");
  const IniFile ini = to_ini(settings);
  Options options;
  read_run_options(ini, options);
  options.workers = asked.workers;
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  options.walkers = section.walkers;
  options.generated_people = section.people;
  options.goal_headings = section.goal_headings;
  options.progress = [&](const std::string& phase, std::size_t done, std::size_t total) {
    const Entered entered;
    if (is_interrupted() || (asked.progress != nullptr &&
                             asked.progress(asked.context, phase.c_str(), done, total) != 0))
      throw Error(ErrorKind::Job, "interrupted");
  };
  const std::shared_ptr<const Generator> family = make_family(ini);
  const Unlocked unlocked;
  return generate(family, asked.count, asked.seed, options);
}

}  // namespace
}  // namespace slalom

using namespace slalom;

slalom_scenarios* slalom_scenarios_new() {
  return make_list([] { return std::vector<Scenario>(); });
}

void slalom_scenarios_free(slalom_scenarios* list) {
  const std::unique_ptr<slalom_scenarios> owner(list);
}

slalom_scenarios* slalom_scenarios_read(const char* path) {
  return make_list([&] { return read_list(text_of(path, "path")); });
}

slalom_scenarios* slalom_scenarios_from_yaml(const char* text) {
  return make_list(
      [&] { return std::vector<Scenario>{scenario_from_yaml(text_of(text, "yaml"), "yaml")}; });
}

slalom_scenarios* slalom_scenarios_generate(const char* family, int count, uint64_t seed,
                                            int workers, const char* settings,
                                            slalom_progress progress, void* context) {
  return make_list([&] {
    const std::string name = text_of(family, "family");
    GeneratorContext maps;
    maps.load_map = load_occupancy_grid;
    return generate_family({count, seed, workers, progress, context}, json_of(settings, "settings"),
                           [&](const IniFile& ini) { return make_generator(name, ini, maps); });
  });
}

slalom_scenarios* slalom_scenarios_generate_own(const char* name, slalom_family family, int count,
                                                uint64_t seed, int workers, const char* settings,
                                                slalom_progress progress, void* context) {
  return make_list([&] {
    const auto own = std::make_shared<OwnFamily>(text_of(name, "name"), family, context);
    return generate_family({count, seed, workers, progress, context}, json_of(settings, "settings"),
                           [&](const IniFile&) { return own; });
  });
}

int slalom_scenarios_add(slalom_scenarios* list, const slalom_scenarios* from, size_t index) {
  return guarded(-1, [&] {
    list_of(list).scenarios.push_back(Scenario(scenario_of(from, index)));
    return 0;
  });
}

size_t slalom_scenarios_size(const slalom_scenarios* list) {
  return list == nullptr ? 0 : list->scenarios.size();
}

int slalom_scenarios_write(const slalom_scenarios* list, const char* path) {
  return guarded(-1, [&] {
    ScenarioList::write(text_of(path, "path"),
                        [&](ScenarioList& file) { file.add_all(list_of(list).scenarios); });
    return 0;
  });
}

char* slalom_scenario_json(const slalom_scenarios* list, size_t index) {
  return text_about(list, index, describe_scenario);
}

char* slalom_scenario_yaml(const slalom_scenarios* list, size_t index) {
  return text_about(list, index,
                    [](const Scenario& scenario) { return scenario_to_yaml(scenario); });
}

char* slalom_scenario_svg(const slalom_scenarios* list, size_t index) {
  return text_about(list, index, [](const Scenario& scenario) { return render_svg(scenario, {}); });
}

uint8_t* slalom_scenario_occupancy(const slalom_scenarios* list, size_t index, double resolution,
                                   size_t* rows, size_t* columns) {
  return guarded<uint8_t*>(nullptr, [&] {
    if (rows == nullptr || columns == nullptr)
      throw usage_error("occupancy", "a size is a null pointer", "rows and columns");
    const Occupancy occupancy = make_occupancy(scenario_of(list, index), resolution);
    auto* cells = owned_array<uint8_t>(occupancy.cells().size());
    std::copy(occupancy.cells().begin(), occupancy.cells().end(), cells);
    *rows = static_cast<std::size_t>(occupancy.size_y());
    *columns = static_cast<std::size_t>(occupancy.size_x());
    return cells;
  });
}
