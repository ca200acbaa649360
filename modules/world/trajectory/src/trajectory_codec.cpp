// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/byte_stream.h>
#include <slalom/trajectory/trajectory_codec.h>

namespace slalom {
namespace {

constexpr std::uint8_t kVersion = 4;

}  // namespace

std::string to_bytes(const Trajectory& trajectory) {
  ByteWriter out;
  out.u8(kVersion).u64(trajectory.samples.size());
  for (const Sample& s : trajectory.samples)
    for (const double number : s.numbers()) out.f64(number);
  return out.take();
}

Trajectory trajectory_from_bytes(const std::string& bytes, const std::string& where) {
  ByteReader in(bytes, where);
  in.expect_version(kVersion);
  Trajectory trajectory;
  trajectory.samples.resize(in.count(sizeof(double) * Sample::kNumbers));
  for (Sample& s : trajectory.samples) {
    std::array<double, Sample::kNumbers> numbers{};
    for (double& number : numbers) number = in.f64();
    s = Sample::from_numbers(numbers);
  }
  in.expect_end();
  return trajectory;
}

}  // namespace slalom
