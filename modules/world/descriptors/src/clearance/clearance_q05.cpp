// SPDX-License-Identifier: BSD-3-Clause
#include "configuration_space.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace slalom::descriptors {
namespace {

constexpr std::size_t kBuckets = 1U << 13U;

/// Buckets are in the order of distances: floats that are not negative are ordered like their bits.
std::size_t bucket_of(float distance) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &distance, sizeof bits);
  return bits >> 18U;
}

}  // namespace

/// 5 % quantile of d over F_C: the smallest distance not exceeded by at least 5 % of F_C.
Value clearance_q05(const DescriptorContext& context) {
  const SharedArray<float>& distances = context.world.distance_field().centers();
  const FreeHeadings space = free_headings(context);
  std::array<std::size_t, kBuckets> counts = {};
  std::size_t all = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    counts[bucket_of(distances[i])] += space.free[i];
    all += space.free[i];
  }
  if (all == 0) return Value::na("no collision-free configuration");
  std::size_t rank = (all + 19) / 20, bucket = 0;  // 1-based
  while (counts[bucket] < rank) rank -= counts[bucket++];
  std::vector<float> sample;
  sample.reserve(counts[bucket]);
  for (std::size_t i = 0; i < distances.size(); ++i)
    if (bucket_of(distances[i]) == bucket) sample.insert(sample.end(), space.free[i], distances[i]);
  const auto quantile = sample.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(sample.begin(), quantile, sample.end());
  return Value::of(static_cast<double>(*quantile));
}

}  // namespace slalom::descriptors
