// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"

#include <slalom/io/packed_trajectory.h>
#include <slalom/trajectory/trajectory_codec.h>

#include <utility>

namespace slalom {

PackedTrajectory::PackedTrajectory() {
  static const std::string kEmpty = compress(to_bytes(Trajectory()));
  bytes_ = kEmpty;
}

PackedTrajectory::PackedTrajectory(const Trajectory& trajectory)
    : bytes_(compress(to_bytes(trajectory))) {}

PackedTrajectory PackedTrajectory::of_bytes(std::string bytes) {
  PackedTrajectory packed;
  packed.bytes_ = std::move(bytes);
  return packed;
}

Trajectory PackedTrajectory::unpack(const std::string& where) const {
  return trajectory_from_bytes(decompress(bytes_, where), where);
}

}  // namespace slalom
