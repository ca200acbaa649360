// SPDX-License-Identifier: BSD-3-Clause
#include "../free_rays.h"

namespace slalom::descriptors {

/// Traversability of AvoidBench (Yu, de Croon, De Wagter 2023).
Value traversability(const DescriptorContext& context) {
  return Value::of(mean_free_ray(context));
}

}  // namespace slalom::descriptors
