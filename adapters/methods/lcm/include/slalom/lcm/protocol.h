// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/command_t.hpp>
#include <slalom/error_t.hpp>
#include <slalom/hello_t.hpp>
#include <slalom/lcm/layout.h>
#include <slalom/methods/method.h>

#include <lcm/lcm-cpp.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Version of the meaning of the messages of lcm_types/. Changed fields change the fingerprint.
constexpr std::int32_t kLcmProtocolVersion = 1;

/// The channels between one simulator and one external method: PREFIX_HELLO etc.
struct LcmChannels {
  explicit LcmChannels(const std::string& prefix);
  std::string hello, goal_heading, run_start, observation, run_end;  ///< to the method
  std::string ready, command, error;                                 ///< from the method
};

/// Whether messages can be received. LCM opens its socket at the first subscription and crashes
/// later if that failed, for example since another program uses the port alone.
bool can_receive(lcm::LCM& lcm);

using MethodSettings = std::map<std::string, std::string>;

hello_t make_hello(const std::string& method, const RobotModel& robot, const SensorModel& sensor,
                   const MethodSettings& settings);
goal_heading_t make_goal_heading(std::int64_t run_id, const NavigationTask& task);
run_start_t make_run_start(std::int64_t run_id, const NavigationTask& task);
/// Fills all fields except run_id and sequence.
void fill_observation(const Observation& observation, observation_t& message);
Command command_of(const command_t& message);

RobotModel robot_of(const hello_t& hello);
SensorModel sensor_of(const hello_t& hello);  ///< aperture() equals hello.aperture exactly
MethodSettings settings_of(const hello_t& hello);
NavigationTask task_of(const run_start_t& message);

/// A scan that is reused for successive observations.
class ReceivedScan : public mrpt::obs::CObservation2DRangeScan {
 public:
  /// Sets the ranges and clears the point map that MRPT caches for the previous ones.
  void set_ranges(const std::vector<float>& ranges);

 private:
  std::vector<char> valid_;
};

/// Returns the observation; its scan points to `scan`, filled with the ranges.
Observation observation_of(const observation_t& message, const SensorModel& sensor,
                           ReceivedScan& scan);

}  // namespace slalom
