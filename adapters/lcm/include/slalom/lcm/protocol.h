#pragma once

#include <slalom/command_t.hpp>
#include <slalom/error_t.hpp>
#include <slalom/hello_t.hpp>
#include <slalom/methods/method.h>
#include <slalom/observation_t.hpp>
#include <slalom/ready_t.hpp>
#include <slalom/run_end_t.hpp>
#include <slalom/run_start_t.hpp>

#include <cstdint>
#include <exception>
#include <map>
#include <string>

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
/// The observation but for its scan; `scan` is filled with the ranges and refers to `sensor`.
Observation observation_of(const observation_t& message, const SensorModel& sensor,
                           mrpt::obs::CObservation2DRangeScan& scan);

/// Whether `count` 32-bit integers after the fingerprint are sizes that `size` bytes can hold.
/// Generated decoders take memory for them without a look.
bool sizes_fit(const void* data, std::size_t size, int count);

/// How many sizes of arrays a message begins with.
template <typename Message>
constexpr int array_sizes = 0;
template <>
inline constexpr int array_sizes<hello_t> = 2;
template <>
inline constexpr int array_sizes<observation_t> = 1;

/// Decodes what came from the network; false for what is no such message.
template <typename Message>
bool decode_message(const void* data, std::size_t size, Message& message) {
  if (size > INT32_MAX || !sizes_fit(data, size, array_sizes<Message>)) return false;
  try {
    return message.decode(data, 0, static_cast<int>(size)) == static_cast<int>(size);
  } catch (const std::exception&) {
    return false;  // negative lengths within
  }
}

}  // namespace slalom
