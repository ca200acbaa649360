// SPDX-License-Identifier: BSD-3-Clause
#include "network.h"
#include "network_input.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>
#include <slalom/methods/registry.h>
#include <slalom/onnx/onnx_method.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace slalom {
namespace {

std::string shape_text(const std::vector<int>& shape) {
  std::vector<std::string> sides;
  for (const int side : shape) sides.push_back(std::to_string(side));
  return join(sides, "x");
}

class OnnxMethod : public Method {
 public:
  OnnxMethod(const OnnxOptions& options, const std::string& path, const RobotModel& robot,
             const SensorModel& sensor, const OptionLocation& where)
      : output_(options.output),
        robot_(robot),
        encoder_(options, robot, sensor, where("scan_size")),
        inputs_(parse_network_inputs(options.inputs, where("inputs"))),
        network_(path, resolve_plugin_path(options.runtime, options.folder, where("runtime")),
                 where) {
    for (NetworkInput& input : inputs_) set_shape(input, where("inputs"));
    check_fit(where);
  }

  void reset(const NavigationTask&) override { limited_ = 0; }

  Command step(const Observation& observation) override {
    std::vector<std::vector<float>> values;
    for (const NetworkInput& input : inputs_) values.push_back(encoder_.encode(input, observation));
    const std::vector<float> output = network_.evaluate(inputs_, values);
    const double vy = output.size() > 2 ? static_cast<double>(output[2]) : 0;
    return decode(static_cast<double>(output[0]), static_cast<double>(output[1]), vy);
  }

  std::map<std::string, double> run_figures() const override {
    return {{"commands_limited", limited_}};
  }

 private:
  void set_shape(NetworkInput& input, const std::string& where) const {
    const auto size = static_cast<int>(encoder_.size(input));
    if (input.shape.empty()) input.shape = {1, size};
    const auto product = std::accumulate(input.shape.begin(), input.shape.end(), std::int64_t{1},
                                         std::multiplies<>());
    if (product != size)
      throw usage_error(where, "the shape " + shape_text(input.shape) + " does not fit",
                        "a product of " + std::to_string(size) + ", the number of values");
  }

  /// A first evaluation, of zeros, shows whether the inputs fit the network and what it returns.
  void check_fit(const OptionLocation& where) {
    std::vector<std::vector<float>> zeros;
    std::vector<std::string> shapes;
    for (const NetworkInput& input : inputs_) {
      zeros.emplace_back(encoder_.size(input));
      shapes.push_back(shape_text(input.shape));
    }
    std::size_t outputs = 0;
    try {
      outputs = network_.evaluate(inputs_, zeros).size();
    } catch (const MethodError& error) {
      throw usage_error(where("inputs"),
                        std::string(error.what()) + " (inputs: " + join(shapes, ", ") + ")",
                        "the inputs with which the network was trained");
    }
    const std::size_t expected = robot_.holonomic() ? 3 : 2;
    if (outputs != expected)
      throw usage_error(where("model"), "the network has " + std::to_string(outputs) + " outputs",
                        std::to_string(expected) + (robot_.holonomic() ? ": v, w, vy" : ": v, w"));
  }

  /// Commands beyond the limits become the nearest ones within; NaN stays.
  Command decode(double v, double w, double vy) {
    if (output_ == NetworkOutput::Scaled) {
      v *= robot_.max_v;
      w *= robot_.max_w;
      vy *= robot_.max_v;
    }
    return limited_command({v, w, vy}, robot_, limited_);
  }

  double limited_ = 0;  // commands of the run beyond the limits
  NetworkOutput output_;
  RobotModel robot_;
  InputEncoder encoder_;
  std::vector<NetworkInput> inputs_;
  Network network_;
};

MethodFactory make_factory(const OnnxOptions& options, const OptionLocation& where) {
  return [options, where](const RobotModel& robot, const SensorModel& sensor) {
    if (options.model.empty()) throw usage_error(where(""), "missing model", "model = FILE.onnx");
    const std::string path =
        resolve_method_file("model", options.model, options.folder, where("model"));
    return std::make_unique<OnnxMethod>(options, path, robot, sensor, where);
  };
}

}  // namespace

void OnnxOptions::visit(OptionVisitor& v) {
  v.option("model", model, External::Code, "file of the network, .onnx");
  v.option("inputs", inputs,
           "inputs of the network, separated by ';': CONTENTS, or NAME: CONTENTS as 1xN, with "
           "contents of scan, goal, velocity");
  v.option("scan_size", scan_size, "-",
           "values of the scan, minima of neighboring rays; 0: one for each ray",
           Range::between(0, 1e6));
  v.option("scan_scaling", scan_scaling,
           "ranges over max_range (divide), 1 minus that (inverse), or m (none)");
  v.option("goal_distance", goal_distance, "m", "distance of the goal that is given as 1, at most",
           Range::positive());
  v.option("output", output, "fractions of the limits (scaled), or m/s and rad/s (physical)");
  v.option("runtime", runtime, External::Library, "library that evaluates networks");
}

MethodFactory onnx_method(const OnnxOptions& options) {
  return make_factory(options, location_of("onnx_method"));
}

MethodFactory read_onnx_method(const IniFile& ini, const std::string& section) {
  auto options = read_adapter_options<OnnxOptions>(ini, section);
  options.folder = ini.folder();
  return make_factory(options, location_in(ini, section));
}

}  // namespace slalom
