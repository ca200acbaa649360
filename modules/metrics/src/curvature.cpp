#include "common.h"
#include "curve.h"
#include "families.h"

#include <algorithm>
#include <numeric>

namespace slalom {
namespace {

constexpr char kTooShort[] = "the path driven is too short to have a curvature";

/// (1/L) integral of the squared curvature along the path: its mean over points of equal distance.
class BendingEnergy : public Metric {
 public:
  QuantityInfo info() const override {
    return {"bending_energy", 1, "Bending energy", "1/m^2", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_samples(context)) return *na;
    const std::vector<double> k = curvatures(context.trajectory.path());
    if (k.empty()) return Value::na(kTooShort);
    return Value::of(std::inner_product(k.begin(), k.end(), k.begin(), 0.0) /
                     static_cast<double>(k.size()));
  }
};

/// The largest curvature.
class MaxCurvature : public Metric {
 public:
  QuantityInfo info() const override {
    return {"max_curvature", 1, "Largest curvature", "1/m", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_samples(context)) return *na;
    const std::vector<double> k = curvatures(context.trajectory.path());
    if (k.empty()) return Value::na(kTooShort);
    return Value::of(*std::max_element(k.begin(), k.end()));
  }
};

}  // namespace

MetricPtr make_bending_energy() {
  return std::make_shared<BendingEnergy>();
}
MetricPtr make_max_curvature() {
  return std::make_shared<MaxCurvature>();
}

}  // namespace slalom
