#include "confined_share.h"
#include "descriptors.h"

#include <slalom/core/text.h>

#include <cmath>

namespace slalom {
namespace {

/// (1/area F) integral over F of the share of directions in which a ray meets O within R.
///
/// Places come from the additive recurrence with the plastic number (Roberts' R2 sequence), those
/// in F are kept; each is looked around from, its rays turned from place to place by the golden
/// ratio. More places are added until the standard error of their mean is at most
/// kWantedError. On request the exact arcs at the centres of all free cells are summed up instead.
class Confinement : public Descriptor {
 public:
  QuantityInfo info() const override {
    return {"confinement", 1, "Confinement", "-", Direction::None};
  }

  std::string parameters(const DescriptorContext& context) const override {
    return join_parameters({"sensor_range=" + format_number(context.sensor_range),
                            resolution_parameter(context.world),
                            context.exact_confinement ? "confinement=exact" : ""});
  }

  Value compute(const DescriptorContext& context) const override {
    const Occupancy& cells = context.world.occupancy();
    if (cells.count_occupied() == cells.cells().size()) return Value::na("no free space");
    if (context.exact_confinement)
      return Value::of(slalom::exact_confinement(cells, context.sensor_range));
    return sample(context, cells);
  }

 private:
  Value sample(const DescriptorContext& context, const Occupancy& cells) const {
    Mean mean;
    for (int i = 1;
         i <= kMostPlaces && !(mean.count() >= kLeastPlaces && mean.error() <= kWantedError); ++i) {
      const mrpt::math::TPoint2D place = cells.to_world(fraction(0.5 + i * kR2X) * cells.size_x(),
                                                        fraction(0.5 + i * kR2Y) * cells.size_y());
      const mrpt::math::TPoint2D at = cells.to_cells(place);
      if (cells.occupied(static_cast<int>(at.x), static_cast<int>(at.y))) continue;
      mean.add(
          confined_share(context.world, place, context.sensor_range, fraction(i * kGoldenRatio)));
    }
    if (mean.count() == 0) return Value::na("no free place among " + std::to_string(kMostPlaces));
    return Value::of(mean.value(), mean.error());
  }

  static constexpr int kLeastPlaces = 200;
  static constexpr int kMostPlaces = 200000;
  static constexpr double kWantedError = 0.005;
  static constexpr double kR2X = 0.7548776662466927;  // 1/p and 1/p^2, p the plastic number
  static constexpr double kR2Y = 0.5698402909980532;

  /// Mean and its standard error as if the places were independent, which for this even sample is
  /// on the safe side.
  class Mean {
   public:
    void add(double x) {
      ++count_;
      const double change = x - mean_;
      mean_ += change / count_;
      squares_ += change * (x - mean_);
    }
    int count() const { return count_; }
    double value() const { return mean_; }
    double error() const {
      return count_ < 2 ? 1.0 : std::sqrt(squares_ / (count_ - 1.0) / count_);
    }

   private:
    int count_ = 0;
    double mean_ = 0, squares_ = 0;
  };
};

}  // namespace

DescriptorPtr make_confinement() {
  return std::make_shared<Confinement>();
}

}  // namespace slalom
