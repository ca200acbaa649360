#include <slalom/scenario/world.h>

#include <utility>

namespace slalom {
namespace {

template <typename T, typename Make>
const T& make_once(std::unique_ptr<T>& kept, Make make) {
  if (!kept) kept = std::make_unique<T>(make());
  return *kept;
}

}  // namespace

World::World(Scenario scenario, double resolution)
    : scenario_(std::move(scenario)), resolution_(resolution) {}

const Occupancy& World::occupancy() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return make_once(occupancy_, [&] { return make_occupancy(scenario_, resolution_); });
}

const DistanceField& World::distance_field() const {
  const Occupancy& cells = occupancy();
  const std::lock_guard<std::mutex> lock(mutex_);
  return make_once(distance_field_, [&] { return DistanceField(cells); });
}

const RayCaster& World::ray_caster() const {
  const Occupancy& cells = occupancy();
  const std::lock_guard<std::mutex> lock(mutex_);
  return make_once(ray_caster_, [&] { return RayCaster(cells); });
}

}  // namespace slalom
