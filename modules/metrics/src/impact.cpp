#include "common.h"
#include "families.h"

#include <algorithm>

namespace slalom {
namespace {

/// Where the robot was `dt` seconds before this sample, at the sample's speeds.
mrpt::math::TPose2D pose_before(const Sample& sample, double dt) {
  const double phi = sample.pose.phi - sample.w * dt;
  const double c = std::cos(phi), s = std::sin(phi);
  return {sample.pose.x - (sample.v * c - sample.vy * s) * dt,
          sample.pose.y - (sample.v * s + sample.vy * c) * dt, phi};
}

/// Speed along the contact normal at the first contact, which ends a run: how fast the footprint's
/// clearance shrinks there.
class ImpactSpeed : public Metric {
 public:
  QuantityInfo info() const override {
    return {"impact_speed", 1, "Impact speed", "m/s", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (context.outcome != Outcome::Collision)
      return Value::na("outcome: " + to_string(context.outcome));
    if (const auto na = na_without_samples(context)) return *na;
    const Sample& last = context.trajectory.samples.back();
    const double before =
        footprint_clearance(context.world, context.robot.shape(), pose_before(last, kStep));
    const double now = footprint_clearance(context.world, context.robot.shape(), last.pose);
    return Value::of(std::max(0.0, (before - now) / kStep));
  }

 private:
  static constexpr double kStep = 1e-3;  // s: a millimetre or so
};

/// The least time until contact if the clearance went on shrinking as it does: d_i over the speed
/// at which it shrank since the sample before, over the samples at which it shrank.
class MinTimeToCollision : public Metric {
 public:
  QuantityInfo info() const override {
    return {"min_time_to_collision", 1, "Smallest time to collision", "s", Direction::Up};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_time(context)) return *na;
    const auto& samples = context.trajectory.samples;
    std::optional<double> least;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const double gap = context.clearances[i];
      const double closing = (context.clearances[i - 1] - gap) / (samples[i].t - samples[i - 1].t);
      if (closing < kSlowest) continue;
      const double time = std::max(0.0, gap) / closing;
      least = least ? std::min(*least, time) : time;
    }
    return least ? Value::of(*least) : Value::na("the robot never came nearer to an obstacle");
  }

 private:
  static constexpr double kSlowest = 1e-6;  // m/s; slower is rounding
};

}  // namespace

MetricPtr make_impact_speed() {
  return std::make_shared<ImpactSpeed>();
}
MetricPtr make_min_time_to_collision() {
  return std::make_shared<MinTimeToCollision>();
}

}  // namespace slalom
