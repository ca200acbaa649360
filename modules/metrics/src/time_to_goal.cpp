#include "common.h"
#include "families.h"

namespace slalom {
namespace {

/// T on success.
class TimeToGoal : public Metric {
 public:
  QuantityInfo info() const override {
    return {"time_to_goal", 1, "Time to goal", "s", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_unless_reached(context)) return *na;
    return Value::of(context.trajectory.duration());
  }
};

/// T on success, 2 T_max on failure: the penalised average of algorithm competitions, PAR2.
class Par2Time : public Metric {
 public:
  QuantityInfo info() const override {
    return {"par2_time", 1, "Time, failures penalised", "s", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_verdict(context)) return *na;
    if (context.outcome != Outcome::Success) return Value::of(2 * context.max_time);
    if (const auto na = na_without_samples(context)) return *na;
    return Value::of(context.trajectory.duration());
  }
};

/// T / (L* / v_max): how many times longer than the shortest path at full speed.
class TimeRatio : public Metric {
 public:
  QuantityInfo info() const override {
    return {"time_ratio", 1, "Time ratio", "-", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_unless_reached(context)) return *na;
    if (const auto na = na_without_time(context)) return *na;
    if (const auto na = na_without_shortest(context)) return *na;
    return Value::of(context.trajectory.duration() * context.robot.max_v /
                     context.references.shortest->length);
  }
};

}  // namespace

MetricPtr make_time_to_goal() {
  return std::make_shared<TimeToGoal>();
}
MetricPtr make_par2_time() {
  return std::make_shared<Par2Time>();
}
MetricPtr make_time_ratio() {
  return std::make_shared<TimeRatio>();
}

}  // namespace slalom
