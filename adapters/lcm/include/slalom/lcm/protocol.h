#pragma once

#include <slalom/command_t.hpp>
#include <slalom/error_t.hpp>
#include <slalom/hello_t.hpp>
#include <slalom/lcm/layout.h>
#include <slalom/methods/method.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Version of what the messages of lcm_types/ mean. Other fields give messages another fingerprint.
constexpr std::int32_t kLcmProtocolVersion = 1;

/// The channels between one simulator and one external method: PREFIX_HELLO and so on.
struct LcmChannels {
  explicit LcmChannels(const std::string& prefix);
  std::string hello, run_start, observation, run_end;  ///< to the method
  std::string ready, command, error;                   ///< from the method
};

using MethodSettings = std::map<std::string, std::string>;

hello_t make_hello(const std::string& method, const RobotModel& robot, const SensorModel& sensor,
                   const MethodSettings& settings);
run_start_t make_run_start(std::int64_t run_id, const Task& task);
/// Fills in all but run_id and sequence.
void fill_observation(const Observation& observation, observation_t& message);
Command command_of(const command_t& message);

RobotModel robot_of(const hello_t& hello);
SensorModel sensor_of(const hello_t& hello);  ///< aperture() gives the hello's bits again
MethodSettings settings_of(const hello_t& hello);
Task task_of(const run_start_t& message);

/// A scan for one observation after another.
class ReceivedScan : public mrpt::obs::CObservation2DRangeScan {
 public:
  /// Also forgets the points that MRPT keeps of the ranges before.
  void take(const std::vector<float>& ranges);

 private:
  std::vector<char> valid_;
};

/// The observation; its scan is `scan`, filled with the ranges.
Observation observation_of(const observation_t& message, const SensorModel& sensor,
                           ReceivedScan& scan);

}  // namespace slalom
