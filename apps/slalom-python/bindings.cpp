// SPDX-License-Identifier: BSD-3-Clause
#include "arguments.h"
#include "certify.h"
#include "results.h"
#include "scenarios.h"

#include <slalom/core/error.h>
#include <slalom/core/version.h>
#include <slalom/evaluate.h>

#include <optional>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace {

namespace py = pybind11;

/// Sets what evaluate() has besides the sections of an .ini.
struct EvaluateArguments {
  std::optional<std::vector<std::string>> metrics, descriptors;
  std::uint64_t seed = 1;
  int repetitions = 1, workers = 1;
  bool in_process = false, trajectories = false;
};

slalom::Options to_options(const EvaluateArguments& arguments, const py::dict& sections,
                           const py::object& progress) {
  slalom::Options options = slalom::read_evaluate_options(slalom::to_ini(sections));
  if (arguments.metrics) options.metrics = *arguments.metrics;
  if (arguments.descriptors) options.descriptors = *arguments.descriptors;
  options.seed = arguments.seed;
  options.repetitions = arguments.repetitions;
  options.workers = arguments.workers;
  options.in_process = arguments.in_process;
  if (!progress.is_none())
    options.progress = [progress](const std::string& phase, std::size_t done, std::size_t total) {
      progress(phase, done, total);
    };
  // Ctrl-C sets a flag, which becomes KeyboardInterrupt when the evaluation has ended.
  options.cancel = [] { return PyErr_CheckSignals() != 0; };
  return options;
}

/// (columns, timing, reasons, trajectories or None, table)
py::tuple evaluate(const py::dict& methods, const std::vector<slalom::Scenario>& scenarios,
                   const EvaluateArguments& arguments, const py::dict& sections,
                   const py::object& progress) {
  slalom::Options options = to_options(arguments, sections, progress);
  std::map<std::string, slalom::Trajectory> trajectories;
  if (arguments.trajectories)
    options.observer = [&](const slalom::RunRecord& run, const slalom::Trajectory& trajectory) {
      trajectories.emplace(slalom::run_id(run), trajectory);
    };
  auto table = std::make_shared<slalom::ResultTable>(
      slalom::evaluate(slalom::to_methods(methods), scenarios, options));
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  const py::object arrays =
      arguments.trajectories ? py::object(arrays_of(*table, trajectories)) : py::none();
  return py::make_tuple(columns_of(*table), timing_of(*table), reasons_of(*table), arrays, table);
}

}  // namespace

PYBIND11_MODULE(_slalom, module) {
  py::register_exception<slalom::Error>(module, "Error", PyExc_ValueError);
  module.attr("__version__") = slalom::version();
  slalom::bind_scenarios(module);
  slalom::bind_certify(module);
  py::class_<slalom::ResultTable, std::shared_ptr<slalom::ResultTable>>(module, "ResultTable")
      .def_property_readonly("manifest",
                             [](const slalom::ResultTable& table) { return table.manifest; });
  module.def(
      "evaluate",
      [](const py::dict& methods, const std::vector<slalom::Scenario>& scenarios,
         const py::dict& sections, std::optional<std::vector<std::string>> metrics,
         std::optional<std::vector<std::string>> descriptors, std::uint64_t seed, int repetitions,
         int workers, bool in_process, bool trajectories, const py::object& progress) {
        return evaluate(methods, scenarios,
                        {std::move(metrics), std::move(descriptors), seed, repetitions, workers,
                         in_process, trajectories},
                        sections, progress);
      });
  module.def("cross_table", slalom::cross_table);
}
