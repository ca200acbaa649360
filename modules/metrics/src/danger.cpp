#include "common.h"
#include "families.h"

#include <algorithm>

namespace slalom {
namespace {

/// Share of an interval over which a clearance, linear between its ends, is below `limit`.
double share_below(double a, double b, double limit) {
  if (a >= limit && b >= limit) return 0;
  if (a < limit && b < limit) return 1;
  return (limit - std::min(a, b)) / std::abs(a - b);
}

/// Share of time with a clearance below `safe_distance`; clearance is linear between samples.
class RiskTimeRatio : public Metric {
 public:
  QuantityInfo info() const override {
    return {"risk_time_ratio", 1, "Time at risk", "-", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_time(context)) return *na;
    const auto& samples = context.trajectory.samples;
    double at_risk = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
      at_risk +=
          (samples[i].t - samples[i - 1].t) *
          share_below(context.clearances[i - 1], context.clearances[i], context.safe_distance);
    return Value::of(at_risk / context.trajectory.duration());
  }
};

/// Mean over time of 1 / max(d_i, 1 cm).
class InverseClearance : public Metric {
 public:
  QuantityInfo info() const override {
    return {"inverse_clearance", 1, "Inverse clearance", "1/m", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_time(context)) return *na;
    const auto& samples = context.trajectory.samples;
    const auto inverse = [&](std::size_t i) {
      return 1 / std::max(context.clearances[i], kSmallest);
    };
    double sum = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
      sum += 0.5 * (inverse(i - 1) + inverse(i)) * (samples[i].t - samples[i - 1].t);
    return Value::of(sum / context.trajectory.duration());
  }

 private:
  static constexpr double kSmallest = 0.01;  // m
};

}  // namespace

MetricPtr make_risk_time_ratio() {
  return std::make_shared<RiskTimeRatio>();
}
MetricPtr make_inverse_clearance() {
  return std::make_shared<InverseClearance>();
}

}  // namespace slalom
