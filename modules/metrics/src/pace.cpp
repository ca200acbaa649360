#include "common.h"
#include "families.h"
#include "speed.h"

namespace slalom {
namespace {

/// L / T.
class MeanSpeed : public Metric {
 public:
  QuantityInfo info() const override {
    return {"mean_speed", 1, "Mean speed", "m/s", Direction::Up};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_time(context)) return *na;
    return Value::of(length(context.trajectory.path()) / context.trajectory.duration());
  }
};

/// Time with |v| < 0.01 m/s and |w| < 0.02 rad/s.
class TimeStopped : public Metric {
 public:
  QuantityInfo info() const override {
    return {"time_stopped", 1, "Time stopped", "s", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_time(context)) return *na;
    const SpeedProfile speeds = speed_profile(context);
    const std::vector<double> weights = sample_weights(speeds.t);
    double stopped = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (std::abs(speeds.v[i]) < kSlowest && std::abs(speeds.w[i]) < kSlowestTurn)
        stopped += weights[i];
    return Value::of(stopped);
  }

 private:
  static constexpr double kSlowest = 0.01;      // m/s
  static constexpr double kSlowestTurn = 0.02;  // rad/s
};

}  // namespace

MetricPtr make_mean_speed() {
  return std::make_shared<MeanSpeed>();
}
MetricPtr make_time_stopped() {
  return std::make_shared<TimeStopped>();
}

}  // namespace slalom
