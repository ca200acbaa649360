#pragma once

#include <slalom/command_t.hpp>
#include <slalom/error_t.hpp>
#include <slalom/hello_t.hpp>
#include <slalom/observation_t.hpp>
#include <slalom/ready_t.hpp>
#include <slalom/run_end_t.hpp>
#include <slalom/run_start_t.hpp>

#include <cstddef>
#include <cstdint>

namespace slalom {

/// What follows the fingerprint of a message, a letter for each field: b boolean, i 32-bit integer,
/// l 64-bit integer, d double, s string; n a 32-bit integer that is the size of arrays; D doubles
/// and F floats as many as the first n, S strings as many as the last n.
template <typename Message>
inline constexpr const char* kLayout = nullptr;
template <>
inline constexpr const char* kLayout<hello_t> = "nnilsbbdDDddddiddSS";
template <>
inline constexpr const char* kLayout<ready_t> = "ils";
template <>
inline constexpr const char* kLayout<run_start_t> = "ldddddddl";
template <>
inline constexpr const char* kLayout<observation_t> = "nlldddddddddF";
template <>
inline constexpr const char* kLayout<command_t> = "llddd";
template <>
inline constexpr const char* kLayout<run_end_t> = "ls";
template <>
inline constexpr const char* kLayout<error_t> = "ls";

/// Whether the message has this layout and ends with it. The decoders that lcm-gen makes believe
/// the sizes in a message: they take any memory for arrays and read beyond the end for strings.
bool has_layout(const void* data, std::size_t size, const char* layout);

/// Decodes what came from the network; false for what is no such message.
template <typename Message>
bool decode_message(const void* data, std::size_t size, Message& message) {
  return size <= INT32_MAX && has_layout(data, size, kLayout<Message>) &&
         message.decode(data, 0, static_cast<int>(size)) == static_cast<int>(size);
}

}  // namespace slalom
