// SPDX-License-Identifier: BSD-3-Clause
// Time that the adapter python adds to a cycle of a method with 181 rays: `python_method` is
// Method::step() of a class whose step() returns a constant, `bare_call` a call of the same
// function with nothing but an object as argument.
#include <slalom/python/python_method.h>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <pybind11/embed.h>

namespace slalom {
namespace {

constexpr int kRays = 181;

/// The module's file, in a temporary folder that the destructor removes.
class ModuleFile {
 public:
  ModuleFile() {
    std::string name = (std::filesystem::temp_directory_path() / "slalom_python_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
    std::ofstream(folder_ / "constant.py") << "class Constant:\n"
                                              "    def __init__(self, robot, options): pass\n"
                                              "    def reset(self, task): pass\n"
                                              "    def step(self, observation): return 0.5, 0.1\n";
  }
  ~ModuleFile() { std::filesystem::remove_all(folder_); }
  ModuleFile(const ModuleFile&) = delete;
  ModuleFile& operator=(const ModuleFile&) = delete;

  std::unique_ptr<Method> load() const {
    PythonOptions options;
    options.module = "constant.py";
    options.class_name = "Constant";
    options.folder = folder_.string();
    auto method = python_method(options)(RobotModel(), SensorModel());
    method->reset(NavigationTask());
    return method;
  }

 private:
  std::filesystem::path folder_;
};

void python_method(benchmark::State& state) {
  const auto method = ModuleFile().load();
  mrpt::obs::CObservation2DRangeScan scan;
  scan.resizeScan(kRays);
  Observation observation;
  observation.scan = &scan;
  for (auto _ : state) benchmark::DoNotOptimize(method->step(observation));
}

void bare_call(benchmark::State& state) {
  namespace py = pybind11;
  const ModuleFile file;
  const auto method = file.load();  // starts the interpreter and imports the module
  const py::gil_scoped_acquire lock;
  const py::object step =
      py::module_::import("constant").attr("Constant")(py::none(), py::none()).attr("step");
  const py::object argument = py::none();
  for (auto _ : state) benchmark::DoNotOptimize(step(argument));
}

BENCHMARK(python_method);
BENCHMARK(bare_call);

}  // namespace
}  // namespace slalom
