// SPDX-License-Identifier: BSD-3-Clause
#include "arguments.h"
#include "scenarios.h"

#include <slalom/campaign/scenario_sources.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/io/svg_scene.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/scenario/occupancy.h>

#include <fmt/format.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace slalom {
namespace {

namespace py = pybind11;

py::tuple bounds_of(const Scenario& scenario) {
  const Bounds& bounds = scenario.bounds();
  return py::make_tuple(bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max);
}

/// Cell [y, x], row 0 at the bottom.
py::array_t<bool> occupancy_of(const Scenario& scenario, double resolution) {
  const Occupancy occupancy = make_occupancy(scenario, resolution);
  py::array_t<bool> cells({occupancy.size_y(), occupancy.size_x()});
  std::copy(occupancy.cells().begin(), occupancy.cells().end(), cells.mutable_data());
  return cells;
}

std::string describe_scenario(const Scenario& scenario) {
  return fmt::format("<slalom.Scenario {} {}, start ({:.2f}, {:.2f}), goal ({:.2f}, {:.2f})>",
                     scenario.name(), scenario.hash().substr(0, 8), scenario.start().x,
                     scenario.start().y, scenario.goal().x, scenario.goal().y);
}

std::vector<Scenario> read_scenarios(const std::string& path) {
  if (ends_with(path, ".yaml")) return {load_scenario_yaml(path)};
  const ScenarioList list = ScenarioList::open(path);
  std::vector<Scenario> scenarios;
  for (const ScenarioList::Entry& entry : list.entries())
    scenarios.push_back(list.read(entry.hash));
  return scenarios;
}

/// Moving obstacles with the keys that they have in YAML.
py::list movers_of(const Scenario& scenario) {
  py::list movers;
  for (const Mover& mover : scenario.movers()) {
    py::list waypoints;
    for (const Waypoint& w : mover.waypoints)
      waypoints.append(py::make_tuple(w.t, w.position.x, w.position.y));
    movers.append(py::dict(py::arg("id") = mover.id, py::arg("radius") = mover.radius,
                           py::arg("after") = to_string(mover.after),
                           py::arg("waypoints") = waypoints));
  }
  return movers;
}

void write_scenarios(const std::string& path, const std::vector<Scenario>& scenarios) {
  ScenarioList::write(path, [&](ScenarioList& list) { list.add_all(scenarios); });
}

std::vector<Scenario> generate_family(const std::string& family, int count, std::uint64_t seed,
                                      int workers, const py::dict& sections,
                                      const py::object& progress) {
  const IniFile ini = to_ini(sections);
  Options options = read_evaluate_options(ini);
  options.workers = workers;
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  options.walkers = section.walkers;
  options.generated_people = section.people;
  options.goal_headings = section.goal_headings;
  GeneratorContext context;
  context.load_map = load_occupancy_grid;
  // Called on any of the threads; signals are those of the one that called generate().
  options.progress = [&progress](const std::string& phase, std::size_t done, std::size_t total) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress.is_none()) progress(phase, done, total);
  };
  const std::shared_ptr<const Generator> generator = make_generator(family, ini, context);
  const py::gil_scoped_release unlocked;
  return generate(generator, count, seed, options);
}

}  // namespace

void bind_scenarios(py::module_& module) {
  py::class_<Scenario>(module, "Scenario")
      .def_property_readonly("name", &Scenario::name)
      .def_property_readonly("hash", &Scenario::hash)
      .def_property_readonly(
          "start",
          [](const Scenario& s) { return py::make_tuple(s.start().x, s.start().y, s.start().phi); })
      .def_property_readonly(
          "goal", [](const Scenario& s) { return py::make_tuple(s.goal().x, s.goal().y); })
      .def_property_readonly("goal_heading", [](const Scenario& s) { return s.goal_heading(); })
      .def_property_readonly("bounds", bounds_of)
      .def_property_readonly("movers", movers_of)
      .def("yaml", scenario_to_yaml)
      .def_static(
          "from_yaml", [](const std::string& text) { return scenario_from_yaml(text, "yaml"); },
          py::arg("text"))
      .def("occupancy", occupancy_of, py::arg("resolution") = 0.05)
      .def("_repr_svg_", [](const Scenario& s) { return render_svg(s, {}); })
      .def("__repr__", describe_scenario)
      .def("__eq__", [](const Scenario& a, const Scenario& b) { return a.hash() == b.hash(); })
      .def("__hash__", [](const Scenario& s) { return py::hash(py::str(s.hash())); });
  module.def("read_scenarios", read_scenarios);
  module.def("write_scenarios", write_scenarios);
  module.def("generate", generate_family);
}

}  // namespace slalom
