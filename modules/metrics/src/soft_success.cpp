#include "common.h"
#include "families.h"

#include <algorithm>

namespace slalom {
namespace {

/// Success that is not all or nothing (Datta et al. 2021): max(0, 1 - |p_end - g| / |s - g|)
/// L* / max(L, L*). L is what was driven.
class SoftSpl : public Metric {
 public:
  QuantityInfo info() const override {
    return {"soft_spl", 1, "Soft success weighted by path length", "-", Direction::Up};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_verdict(context)) return *na;
    if (const auto na = na_without_samples(context)) return *na;
    if (const auto na = na_without_shortest(context)) return *na;
    const Path path = context.trajectory.path();
    const auto& start = context.world.scenario().start();
    const auto& goal = context.world.scenario().goal();
    const double whole = length({{start.x, start.y}, goal});
    if (whole <= 0) return Value::na("the start is the goal");
    const double approached = std::max(0.0, 1 - length({path.back(), goal}) / whole);
    const double best = context.references.shortest->length;
    return Value::of(approached * best / std::max(length(path), best));
  }
};

/// The score of the BARN challenge since 2023: S OT / clip(T, 2 OT, 8 OT), OT = L* / v_max.
class BarnScore : public Metric {
 public:
  QuantityInfo info() const override {
    return {"barn_score_v2", 1, "BARN challenge score", "-", Direction::Up};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_verdict(context)) return *na;
    if (context.outcome != Outcome::Success) return Value::of(0);
    if (const auto na = na_without_samples(context)) return *na;
    if (const auto na = na_without_shortest(context)) return *na;
    const double best = context.references.shortest->length / context.robot.max_v;
    return Value::of(best / std::clamp(context.trajectory.duration(), 2 * best, 8 * best));
  }
};

}  // namespace

MetricPtr make_soft_spl() {
  return std::make_shared<SoftSpl>();
}
MetricPtr make_barn_score() {
  return std::make_shared<BarnScore>();
}

}  // namespace slalom
