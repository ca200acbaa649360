#include "common.h"
#include "families.h"

namespace slalom {
namespace {

/// Goal reached within the tolerance, no collision, in time; 0 otherwise. NA where the failure is
/// not the method's: the scenario has no path, or the machinery failed.
class Success : public Metric {
 public:
  QuantityInfo info() const override { return {"success", 1, "Success", "-", Direction::Up}; }

  Value compute(const MetricContext& context) const override {
    if (const auto na = na_without_verdict(context)) return *na;
    return Value::of(context.outcome == Outcome::Success ? 1 : 0);
  }
};

}  // namespace

MetricPtr make_success() {
  return std::make_shared<Success>();
}

}  // namespace slalom
