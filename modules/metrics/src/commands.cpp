#include "common.h"
#include "families.h"

#include <cmath>

namespace slalom {
namespace {

/// Sum of the changes from sample to sample. Logs of other origin may have no commands: NaN.
template <typename Change>
Value sum_of_changes(const MetricContext& context, Change change) {
  if (const auto na = na_without_time(context)) return *na;
  const auto& samples = context.trajectory.samples;
  double sum = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) sum += change(samples[i - 1], samples[i]);
  return std::isfinite(sum) ? Value::of(sum) : Value::na("no commands are recorded");
}

/// Sum of |change of the speed asked for|.
class CommandVariationV : public Metric {
 public:
  QuantityInfo info() const override {
    return {"command_variation_v", 1, "Variation of commanded speed", "m/s", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    return sum_of_changes(context, [](const Sample& a, const Sample& b) {
      return std::hypot(b.command_v - a.command_v, b.command_vy - a.command_vy);
    });
  }
};

/// Sum of |change of the turning speed asked for|.
class CommandVariationW : public Metric {
 public:
  QuantityInfo info() const override {
    return {"command_variation_w", 1, "Variation of commanded turning", "rad/s", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    return sum_of_changes(context, [](const Sample& a, const Sample& b) {
      return std::abs(b.command_w - a.command_w);
    });
  }
};

/// How often the robot's turning changes its side, turning slower than 0.1 rad/s not counted.
class OscillationCount : public Metric {
 public:
  QuantityInfo info() const override {
    return {"oscillation_count", 1, "Oscillations", "count", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_time(context)) return *na;
    int changes = 0, side = 0;
    for (const Sample& sample : context.trajectory.samples) {
      if (std::abs(sample.w) <= kSlowest) continue;
      const int now = sample.w > 0 ? 1 : -1;
      if (side != 0 && now != side) ++changes;
      side = now;
    }
    return Value::of(changes);
  }

 private:
  static constexpr double kSlowest = 0.1;  // rad/s
};

}  // namespace

MetricPtr make_command_variation_v() {
  return std::make_shared<CommandVariationV>();
}
MetricPtr make_command_variation_w() {
  return std::make_shared<CommandVariationW>();
}
MetricPtr make_oscillation_count() {
  return std::make_shared<OscillationCount>();
}

}  // namespace slalom
