// SPDX-License-Identifier: BSD-3-Clause
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

World::World(Scenario scenario, double resolution, const SharedArray<std::byte>& tables)
    : World(std::move(scenario), resolution) {
  ArrayReader reader(tables);
  occupancy_ = std::make_unique<Occupancy>(Occupancy::read(reader));
  distance_field_ = std::make_unique<DistanceField>(*occupancy_, &reader);
  ray_caster_ = std::make_unique<RayCaster>(*occupancy_, &reader);
  reader.expect_end();
}

void World::write_tables(const ArrayWriter::Sink& sink) const {
  ArrayWriter writer(sink);
  occupancy().write(writer);
  distance_field().write(writer);
  ray_caster().write(writer);
}

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
