// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/byte_stream.h>
#include <slalom/falsification/trial.h>

namespace slalom {

std::string to_bytes(const Trial& trial) {
  ByteWriter writer;
  writer.u8(static_cast<std::uint8_t>(trial.outcome))
      .text(trial.detail)
      .text(trial.trajectory_hash);
  writer.f64(trial.clearance).u64(trial.waypoints.size());
  for (const mrpt::math::TPose2D& pose : trial.waypoints)
    writer.f64(pose.x).f64(pose.y).f64(pose.phi);
  return writer.take();
}

Trial trial_from_bytes(const std::string& bytes, const std::string& where) {
  ByteReader reader(bytes, where);
  Trial trial;
  const std::size_t outcome = reader.u8();
  if (outcome >= enum_values<Outcome>().size()) throw reader.broken("unknown outcome");
  trial.outcome = static_cast<Outcome>(outcome);
  trial.detail = reader.text();
  trial.trajectory_hash = reader.text();
  trial.clearance = reader.f64();
  trial.waypoints.resize(reader.count(3 * sizeof(double)));
  for (mrpt::math::TPose2D& pose : trial.waypoints) {
    pose.x = reader.f64();
    pose.y = reader.f64();
    pose.phi = reader.f64();
  }
  reader.expect_end();
  return trial;
}

}  // namespace slalom
