#include "common.h"
#include "families.h"
#include "path_similarity.h"

namespace slalom {
namespace {

enum class Measure { Frechet, Hausdorff };

/// Frechet or Hausdorff distance of the path driven to P*.
class PathResemblance : public Metric {
 public:
  explicit PathResemblance(Measure measure) : measure_(measure) {}

  QuantityInfo info() const override {
    return measure_ == Measure::Frechet
               ? QuantityInfo{"frechet_to_reference", 1, "Frechet distance to P*", "m",
                              Direction::Down}
               : QuantityInfo{"hausdorff_to_reference", 1, "Hausdorff distance to P*", "m",
                              Direction::Down};
  }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_unless_reached(context)) return *na;
    if (!context.references.shortest) return Value::na(context.references.shortest_reason);
    const Path& reference = context.references.shortest->path;
    const Path driven = context.trajectory.path();
    return Value::of(measure_ == Measure::Frechet ? frechet_distance(driven, reference)
                                                  : hausdorff_distance(driven, reference));
  }

 private:
  Measure measure_;
};

}  // namespace

MetricPtr make_frechet_to_reference() {
  return std::make_shared<PathResemblance>(Measure::Frechet);
}
MetricPtr make_hausdorff_to_reference() {
  return std::make_shared<PathResemblance>(Measure::Hausdorff);
}

}  // namespace slalom
