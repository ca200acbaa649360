#include "configuration_space.h"

#include <algorithm>

namespace slalom::descriptors {

/// 5 % quantile of d over F_C: the smallest distance not exceeded by at least 5 % of F_C.
Value clearance_q05(const DescriptorContext& context) {
  const SharedArray<float>& distances = context.world.distance_field().centers();
  const FreeHeadings space = free_headings(context);
  std::vector<float> sample;
  sample.reserve(distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i)
    for (int heading = 0; heading < space.free[i]; ++heading) sample.push_back(distances[i]);
  if (sample.empty()) return Value::na("no collision-free configuration");
  const std::size_t rank = (sample.size() + 19) / 20;  // 1-based
  const auto quantile = sample.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(sample.begin(), quantile, sample.end());
  return Value::of(static_cast<double>(*quantile));
}

}  // namespace slalom::descriptors
