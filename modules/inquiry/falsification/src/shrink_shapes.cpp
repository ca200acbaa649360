// SPDX-License-Identifier: BSD-3-Clause
#include "shrinker.h"

#include <slalom/generation/scene.h>

#include <cmath>

namespace slalom {
namespace {

/// The disc of the same area.
Disc disc_for(const Polygon& polygon) {
  return {center_of(polygon), std::sqrt(std::abs(signed_area(polygon)) / M_PI)};
}

bool replace(Shrinker& shrinker, std::size_t obstacle, const Scene::Obstacle& by) {
  return shrinker.accept([&] {
    Scene scene(shrinker.scenario());
    scene.obstacles[obstacle] = by;
    return scene.scenario(shrinker.scenario().name());
  });
}

/// Removes corners as long as one can be removed.
bool drop_corners(Shrinker& shrinker, std::size_t obstacle) {
  bool changed = false;
  for (std::size_t corner = 0;;) {
    Polygon polygon = std::get<Polygon>(Scene(shrinker.scenario()).obstacles[obstacle]);
    if (polygon.vertices.size() <= 3 || corner >= polygon.vertices.size()) return changed;
    polygon.vertices.erase(polygon.vertices.begin() + static_cast<std::ptrdiff_t>(corner));
    if (replace(shrinker, obstacle, polygon))
      changed = true;
    else
      ++corner;
  }
}

}  // namespace

bool simplify_shapes(Shrinker& shrinker) {
  if (shrinker.scenario().representation() != Representation::Continuous) return false;
  bool changed = false;
  // Discs precede polygons in a scene: from the last one, a replaced polygon moves none that
  // follow.
  for (std::size_t i = Scene(shrinker.scenario()).obstacles.size(); i-- > 0;) {
    for (bool replaced = true; replaced;) {
      const Scene scene(shrinker.scenario());
      const Polygon* polygon = std::get_if<Polygon>(&scene.obstacles[i]);
      replaced = polygon != nullptr && replace(shrinker, i, disc_for(*polygon));
      changed |= replaced;
    }
    if (std::holds_alternative<Polygon>(Scene(shrinker.scenario()).obstacles[i]))
      changed |= drop_corners(shrinker, i);
  }
  return changed;
}

}  // namespace slalom
