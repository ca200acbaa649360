#include "common.h"
#include "families.h"

#include <algorithm>

namespace slalom {
namespace {

/// L: length of the path driven, positions only.
class PathLength : public Metric {
 public:
  QuantityInfo info() const override {
    return {"path_length", 1, "Path length", "m", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_samples(context)) return *na;
    return Value::of(length(context.trajectory.path()));
  }
};

/// L* / L, L closed to the goal (closed_length), L* the length of the path that was found: at most
/// its certificate's gap above the least possible, so a run may exceed 1 by no more than that.
class Optimality : public Metric {
 public:
  QuantityInfo info() const override { return {"optimality", 1, "Optimality", "-", Direction::Up}; }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_unless_reached(context)) return *na;
    if (!context.references.shortest) return Value::na(context.references.shortest_reason);
    const double driven = closed_length(context);
    if (driven <= 0) return Value::na("the start is the goal");
    return Value::of(context.references.shortest->length / driven);
  }
};

/// Success weighted by path length (Anderson et al. 2018): S L* / max(L, L*), L closed to the goal.
class Spl : public Metric {
 public:
  QuantityInfo info() const override {
    return {"spl", 1, "Success weighted by path length", "-", Direction::Up};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_verdict(context)) return *na;
    if (context.outcome != Outcome::Success) return Value::of(0);
    if (const auto na = na_without_samples(context)) return *na;
    if (!context.references.shortest) return Value::na(context.references.shortest_reason);
    const double best = context.references.shortest->length;
    const double longer = std::max(closed_length(context), best);
    return longer > 0 ? Value::of(best / longer) : Value::na("the start is the goal");
  }
};

/// (1/L*) integral along the trajectory of the distance to P*: the paper's integration over cells.
class OptimalityArea : public Metric {
 public:
  QuantityInfo info() const override {
    return {"optimality_area", 1, "Optimality area", "m", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_unless_reached(context)) return *na;
    if (!context.references.shortest) return Value::na(context.references.shortest_reason);
    const ShortestPath& best = *context.references.shortest;
    if (best.length <= 0) return Value::na("the start is the goal");
    return Value::of(area_between(context.trajectory.path(), best.path) / best.length);
  }
};

/// (L - L*) / L*, L closed to the goal.
class PathExcess : public Metric {
 public:
  QuantityInfo info() const override {
    return {"path_excess", 1, "Path excess", "-", Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_unless_reached(context)) return *na;
    if (const auto na = na_without_shortest(context)) return *na;
    return Value::of(closed_length(context) / context.references.shortest->length - 1);
  }
};

}  // namespace

MetricPtr make_path_length() {
  return std::make_shared<PathLength>();
}
MetricPtr make_optimality() {
  return std::make_shared<Optimality>();
}
MetricPtr make_spl() {
  return std::make_shared<Spl>();
}
MetricPtr make_path_excess() {
  return std::make_shared<PathExcess>();
}
MetricPtr make_optimality_area() {
  return std::make_shared<OptimalityArea>();
}

}  // namespace slalom
