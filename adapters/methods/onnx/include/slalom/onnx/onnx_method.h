// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method_factory.h>

#include <string>

namespace slalom {

/// The meaning of the numbers of a network's output.
enum class NetworkOutput {
  Scaled,   ///< in [-1, 1]: fractions of the robot's limits; v of a forward_only robot: 0 to max_v
  Physical  ///< m/s and rad/s
};
constexpr auto enum_names(NetworkOutput) {
  return std::array{"scaled", "physical"};
}

/// How ranges become inputs of a network.
enum class ScanScaling {
  Divide,   ///< range / max_range
  Inverse,  ///< 1 - range / max_range
  None      ///< m
};
constexpr auto enum_names(ScanScaling) {
  return std::array{"divide", "inverse", "none"};
}

/// A method of the adapter onnx: a learned policy.
struct OnnxOptions {
  std::string model;   ///< the .onnx file
  std::string folder;  ///< that a relative path refers to; in an .ini the folder of the file
  /// The inputs of the network, separated by ";", each "CONTENTS", "NAME: CONTENTS" or "NAME:
  /// CONTENTS as 1x1x61", where CONTENTS lists scan, goal and velocity.
  std::string inputs = "scan, goal, velocity";
  /// Number of values of the scan: minima of equally many neighboring rays; 0: all rays.
  int scan_size = 0;
  ScanScaling scan_scaling = ScanScaling::Divide;
  double goal_distance = 10;  ///< m, at which the distance of the goal is given as 1, its maximum
  NetworkOutput output = NetworkOutput::Scaled;
  /// The library that evaluates networks (runtime/network_runtime.h), see resolve_plugin_path().
  std::string runtime = "runtime/libslalom_onnx_runtime.so";

  void visit(OptionVisitor& v);  ///< without folder
};

/// A method that evaluates a network, by OpenCV's module dnn on one thread, once per control cycle:
/// it has no memory. The factory throws Error (Usage), one line, when the model is missing or
/// cannot be read, the inputs do not fit it, or its output is not (v, w), of a holonomic robot (v,
/// w, vy). Single precision: on another processor the last digits of commands may differ.
MethodFactory onnx_method(const OnnxOptions& options);

/// The same with options from an .ini; a MethodReader.
MethodFactory read_onnx_method(const IniFile& ini, const std::string& section);

}  // namespace slalom
