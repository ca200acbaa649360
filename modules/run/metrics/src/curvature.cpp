// SPDX-License-Identifier: BSD-3-Clause
#include "common.h"
#include "curve.h"

#include <algorithm>
#include <numeric>

namespace slalom::metrics {
namespace {

constexpr char kTooShort[] = "the path is too short for a curvature";

}  // namespace

/// (1/L) integral of the squared curvature along the path: its mean over equidistant points.
Value bending_energy(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return *na;
  const std::vector<double> k = curvatures(context.trajectory.path());
  if (k.empty()) return Value::na(kTooShort);
  return Value::of(std::inner_product(k.begin(), k.end(), k.begin(), 0.0) /
                   static_cast<double>(k.size()));
}

/// The maximum curvature.
Value max_curvature(const MetricContext& context) {
  if (const auto na = na_without_samples(context)) return *na;
  const std::vector<double> k = curvatures(context.trajectory.path());
  if (k.empty()) return Value::na(kTooShort);
  return Value::of(*std::max_element(k.begin(), k.end()));
}

}  // namespace slalom::metrics
