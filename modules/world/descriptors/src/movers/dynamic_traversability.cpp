// SPDX-License-Identifier: BSD-3-Clause
#include "../free_rays.h"
#include "horizon.h"

namespace slalom::descriptors {

/// The mean of traversability with the movers where they are at 0, 2, ..., 12 s. After Shi et al.,
/// "Evaluating Dynamic Environment Difficulty for Obstacle Avoidance Benchmarking", 2024.
Value dynamic_traversability(const DescriptorContext& context) {
  constexpr int kInstants = 7;
  const Movers& movers = context.world.scenario().movers();
  if (movers.empty()) return Value::na(kNoMovers);
  double sum = 0;
  for (int i = 0; i < kInstants; ++i) {
    const double t = kMoverHorizon * i / (kInstants - 1);
    Primitives discs;
    for (const Mover& mover : movers)
      if (mover.present(t)) discs.discs.push_back({mover.position(t), mover.radius});
    sum += mean_free_ray(context, discs);
  }
  return Value::of(sum / kInstants);
}

}  // namespace slalom::descriptors
