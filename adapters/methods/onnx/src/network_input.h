// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method.h>
#include <slalom/onnx/onnx_method.h>

#include <string>
#include <vector>

namespace slalom {

/// The content of a part of an input.
enum class InputContent {
  Scan,     ///< scan_size values
  Goal,     ///< distance / goal_distance, at most 1; cosine and sine of its bearing
  Velocity  ///< measured v / max_v and w / max_w; of a holonomic robot also vy / max_v
};
constexpr auto enum_names(InputContent) {
  return std::array{"scan", "goal", "velocity"};
}

/// One input of a network.
struct NetworkInput {
  std::string name;  ///< "" for the only one
  std::vector<InputContent> contents;
  std::vector<int> shape;  ///< as given; empty: 1 x number of values
};

/// Parses the key `inputs`. Throws Error (Usage) at `where`.
std::vector<NetworkInput> parse_network_inputs(const std::string& text, const std::string& where);

/// Makes the values of inputs.
class InputEncoder {
 public:
  /// Throws Error (Usage) at `where` if the rays cannot be grouped.
  InputEncoder(const OnnxOptions& options, const RobotModel& robot, const SensorModel& sensor,
               const std::string& where);

  std::vector<float> encode(const NetworkInput& input, const Observation& observation) const;
  /// The number of values of an input.
  std::size_t size(const NetworkInput& input) const;

 private:
  std::size_t size(InputContent content) const;
  void add_scan(const Observation& observation, std::vector<float>& values) const;
  void add_goal(const Observation& observation, std::vector<float>& values) const;
  void add_velocity(const Observation& observation, std::vector<float>& values) const;

  OnnxOptions options_;
  RobotModel robot_;
  double max_range_;
  std::size_t rays_, scan_size_;
};

}  // namespace slalom
