#pragma once

#include <slalom/scenario/distance_field.h>
#include <slalom/scenario/occupancy.h>
#include <slalom/scenario/ray_caster.h>
#include <slalom/scenario/scenario.h>

#include <memory>
#include <mutex>

namespace slalom {

/// A scenario with what is derived from it for speed, each made when it is first asked for and then
/// kept (Proxy): its occupancy, distance field and ray tables. The occupancy is the model in which
/// collisions are judged, sensors see and reference paths are free.
class World {
 public:
  /// `resolution` (m) is the cell size for scenarios that are not grids themselves.
  World(Scenario scenario, double resolution);

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
