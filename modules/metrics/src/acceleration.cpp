#include "common.h"
#include "families.h"
#include "speed.h"

namespace slalom {
namespace {

enum class Motion { Linear, Angular };

/// A difference quotient of the speed and the seconds that it stands for.
struct Rate {
  double value, dt;
};

std::vector<Rate> accelerations(const SpeedProfile& speeds, Motion motion) {
  const std::vector<double>& speed = motion == Motion::Linear ? speeds.v : speeds.w;
  std::vector<Rate> rates;
  for (std::size_t i = 1; i < speed.size(); ++i) {
    const double dt = speeds.t[i] - speeds.t[i - 1];
    rates.push_back({(speed[i] - speed[i - 1]) / dt, dt});
  }
  return rates;
}

/// Second differences of the speed: changes between accelerations, which hold in the middles of
/// their intervals.
std::vector<Rate> jerks(const std::vector<Rate>& accelerations) {
  std::vector<Rate> rates;
  for (std::size_t i = 1; i < accelerations.size(); ++i) {
    const double dt = 0.5 * (accelerations[i].dt + accelerations[i - 1].dt);
    rates.push_back({(accelerations[i].value - accelerations[i - 1].value) / dt, dt});
  }
  return rates;
}

/// Root mean square over time.
Value rms(const std::vector<Rate>& rates, const char* needed) {
  if (rates.empty()) return Value::na(needed);
  double sum = 0, time = 0;
  for (const Rate& rate : rates) {
    sum += rate.value * rate.value * rate.dt;
    time += rate.dt;
  }
  return Value::of(std::sqrt(sum / time));
}

class RmsAcceleration : public Metric {
 public:
  explicit RmsAcceleration(Motion motion) : motion_(motion) {}

  QuantityInfo info() const override {
    return motion_ == Motion::Linear
               ? QuantityInfo{"rms_linear_acceleration", 1, "Linear acceleration", "m/s^2",
                              Direction::Down}
               : QuantityInfo{"rms_angular_acceleration", 1, "Angular acceleration", "rad/s^2",
                              Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_time(context)) return *na;
    const SpeedProfile speeds = without_short_intervals(speed_profile(context));
    return rms(accelerations(speeds, motion_), "fewer than two samples");
  }

 private:
  Motion motion_;
};

class RmsJerk : public Metric {
 public:
  explicit RmsJerk(Motion motion) : motion_(motion) {}

  QuantityInfo info() const override {
    return motion_ == Motion::Linear
               ? QuantityInfo{"rms_linear_jerk", 1, "Linear jerk", "m/s^3", Direction::Down}
               : QuantityInfo{"rms_angular_jerk", 1, "Angular jerk", "rad/s^3", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_time(context)) return *na;
    const SpeedProfile speeds = without_short_intervals(speed_profile(context));
    return rms(jerks(accelerations(speeds, motion_)), "fewer than three samples");
  }

 private:
  Motion motion_;
};

}  // namespace

MetricPtr make_rms_linear_acceleration() {
  return std::make_shared<RmsAcceleration>(Motion::Linear);
}
MetricPtr make_rms_angular_acceleration() {
  return std::make_shared<RmsAcceleration>(Motion::Angular);
}
MetricPtr make_rms_linear_jerk() {
  return std::make_shared<RmsJerk>(Motion::Linear);
}
MetricPtr make_rms_angular_jerk() {
  return std::make_shared<RmsJerk>(Motion::Angular);
}

}  // namespace slalom
