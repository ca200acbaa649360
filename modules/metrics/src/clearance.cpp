#include "common.h"
#include "families.h"

#include <algorithm>

namespace slalom {
namespace {

/// Smallest clearance of the footprint over the samples.
class MinClearance : public Metric {
 public:
  QuantityInfo info() const override {
    return {"min_clearance", 1, "Smallest clearance", "m", Direction::Up};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_samples(context)) return *na;
    return Value::of(*std::min_element(context.clearances.begin(), context.clearances.end()));
  }
};

/// Mean clearance of the footprint, weighted by the length driven between samples.
class MeanClearance : public Metric {
 public:
  QuantityInfo info() const override {
    return {"mean_clearance", 1, "Mean clearance", "m", Direction::Up};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_samples(context)) return *na;
    const Path path = context.trajectory.path();
    double sum = 0, driven = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const double piece = length({path[i - 1], path[i]});
      sum += 0.5 * (context.clearances[i - 1] + context.clearances[i]) * piece;
      driven += piece;
    }
    if (driven <= 0) return Value::na("the robot did not move");
    return Value::of(sum / driven);
  }
};

}  // namespace

MetricPtr make_min_clearance() {
  return std::make_shared<MinClearance>();
}
MetricPtr make_mean_clearance() {
  return std::make_shared<MeanClearance>();
}

}  // namespace slalom
