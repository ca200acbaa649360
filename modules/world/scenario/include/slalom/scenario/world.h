// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/distance_field.h>
#include <slalom/scenario/occupancy.h>
#include <slalom/scenario/ray_caster.h>
#include <slalom/scenario/scenario.h>

#include <memory>
#include <mutex>

namespace slalom {

/// A scenario with derived data for speed: its occupancy, distance field and ray tables, each
/// computed on first use and cached (thread-safe). The occupancy is the common model for collision
/// checking, sensing and reference paths.
class World {
 public:
  /// `resolution` (m) is the cell size for scenarios that are not grids themselves.
  World(Scenario scenario, double resolution);
  /// Takes tables that another process wrote for the same scenario and resolution. The tables of
  /// the distance field and ray caster are not copied. Throws Error when `tables` is malformed.
  World(Scenario scenario, double resolution, const SharedArray<std::byte>& tables);

  /// Writes all tables for other processes, after computing those that are missing.
  void write_tables(const ArrayWriter::Sink& sink) const;

  const Scenario& scenario() const { return scenario_; }
  double requested_resolution() const { return resolution_; }
  const Occupancy& occupancy() const;
  const DistanceField& distance_field() const;
  const RayCaster& ray_caster() const;

 private:
  Scenario scenario_;
  double resolution_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<Occupancy> occupancy_;
  mutable std::unique_ptr<DistanceField> distance_field_;
  mutable std::unique_ptr<RayCaster> ray_caster_;
};

}  // namespace slalom
