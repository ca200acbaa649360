// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/trajectory/trajectory.h>

#include <string>

namespace slalom {

/// A trajectory as result files contain it: compressed, without loss. Workers pack theirs, so that
/// whoever writes the file only copies bytes.
class PackedTrajectory {
 public:
  PackedTrajectory();                              ///< no samples
  PackedTrajectory(const Trajectory& trajectory);  // NOLINT: where one is needed the other is good
  static PackedTrajectory of_bytes(std::string bytes);  ///< untrusted: unpack() checks them

  const std::string& bytes() const { return bytes_; }
  /// Throws Error (File) at `where` when the bytes are not those of a trajectory.
  Trajectory unpack(const std::string& where) const;

 private:
  std::string bytes_;
};

}  // namespace slalom
