// SPDX-License-Identifier: BSD-3-Clause
#include "arguments.h"
#include "certify.h"
#include "results.h"
#include "scenarios.h"

#include <slalom/core/error.h>
#include <slalom/core/version.h>
#include <slalom/evaluate.h>
#include <slalom/library/library_method.h>

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
  std::string output;
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
  options.output = arguments.output;
  if (!progress.is_none())
    options.progress = [progress](const std::string& phase, std::size_t done, std::size_t total) {
      progress(phase, done, total);
    };
  // Ctrl-C sets a flag, which becomes KeyboardInterrupt when the evaluation has ended.
  options.cancel = [] { return PyErr_CheckSignals() != 0; };
  return options;
}

/// Results as of results_of().
py::tuple evaluate(const py::dict& methods, const std::vector<slalom::Scenario>& scenarios,
                   const EvaluateArguments& arguments, const py::dict& sections,
                   const py::object& progress) {
  const slalom::ResultTable table = slalom::evaluate(slalom::to_methods(methods), scenarios,
                                                     to_options(arguments, sections, progress));
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  return slalom::results_of(table, arguments.output, arguments.trajectories);
}

}  // namespace

PYBIND11_MODULE(_slalom, module) {
  py::register_exception<slalom::Error>(module, "Error", PyExc_ValueError);
  module.attr("__version__") = slalom::version();
  slalom::bind_scenarios(module);
  slalom::bind_certify(module);
  slalom::bind_results(module);
  module.def("set_shipped_folder", &slalom::set_shipped_folder);
  module.def("evaluate",
             [](const py::dict& methods, const std::vector<slalom::Scenario>& scenarios,
                const py::dict& sections, std::optional<std::vector<std::string>> metrics,
                std::optional<std::vector<std::string>> descriptors, std::uint64_t seed,
                int repetitions, int workers, bool in_process, bool trajectories,
                const py::object& progress, const std::string& output) {
               return evaluate(methods, scenarios,
                               {std::move(metrics), std::move(descriptors), seed, repetitions,
                                workers, in_process, trajectories, output},
                               sections, progress);
             });
}
