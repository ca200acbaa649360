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

}  // namespace

MetricPtr make_time_to_goal() {
  return std::make_shared<TimeToGoal>();
}

}  // namespace slalom
