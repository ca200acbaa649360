// SPDX-License-Identifier: BSD-3-Clause
#include "sums_kernel.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sums_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which sets the instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace slalom {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Reals = hn::CappedTag<double, SumArrays::kLanes>;
using Vector = hn::Vec<Reals>;

/// a b - product, exactly.
Vector product_error(Vector a, Vector b, Vector product) {
#if HWY_NATIVE_FMA
  return hn::MulSub(a, b, product);
#else
  const Reals tag;
  HWY_ALIGN double factors[2][hn::MaxLanes(Reals())], errors[hn::MaxLanes(Reals())];
  hn::Store(a, tag, factors[0]);
  hn::Store(b, tag, factors[1]);
  hn::Store(product, tag, errors);
  for (std::size_t i = 0; i < hn::Lanes(tag); ++i)
    errors[i] = std::fma(factors[0][i], factors[1][i], -errors[i]);
  return hn::Load(tag, errors);
#endif
}

/// The sums of as many cells as a vector has lanes.
class Lanes {
 public:
  Lanes(double* sums, std::size_t stride) : sums_(sums), stride_(stride) {}

  Vector get(SumArrays::Kind kind) const { return hn::LoadU(Reals(), sums_ + kind * stride_); }
  void set(SumArrays::Kind kind, Vector value) const {
    hn::StoreU(value, Reals(), sums_ + kind * stride_);
  }
  void add(SumArrays::Kind kind, Vector term) const { set(kind, hn::Add(get(kind), term)); }
  /// Adds like PreciseSum::add(); the low part follows the high one.
  void add_precisely(SumArrays::Kind high, Vector term, Vector term_error) const {
    const auto low = static_cast<SumArrays::Kind>(high + 1);
    const Vector before = get(high), sum = hn::Add(before, term), part = hn::Sub(sum, before);
    const Vector error = hn::Add(hn::Sub(before, hn::Sub(sum, part)), hn::Sub(term, part));
    set(low, hn::Add(hn::Add(get(low), error), term_error));
    set(high, sum);
  }
  void add_product(SumArrays::Kind high, Vector a, Vector b) const {
    const Vector product = hn::Mul(a, b);
    add_precisely(high, product, product_error(a, b, product));
  }

 private:
  double* sums_;
  std::size_t stride_;
};

void add_to_sums(const double* values, std::size_t stride, double* sums) {
  const Reals tag;
  const Vector one = hn::Set(tag, 1), zero = hn::Zero(tag);
  for (std::size_t i = 0; i < stride; i += hn::Lanes(tag)) {
    const Lanes lanes(sums + i, stride);
    const Vector read = hn::LoadU(tag, values + i);
    const auto available = hn::Eq(read, read);
    const Vector value = hn::IfThenElseZero(available, read);
    lanes.add(SumArrays::ScenarioSum, value);
    lanes.add(SumArrays::ScenarioSize, hn::IfThenElseZero(available, one));
    lanes.add(SumArrays::ScenarioPositives, hn::IfThenElseZero(hn::Ne(value, zero), one));
    lanes.add_precisely(SumArrays::SumHigh, value, zero);
    lanes.add_product(SumArrays::SquaresHigh, value, value);
  }
}

void close_scenario_of_sums(std::size_t stride, double* sums) {
  const Reals tag;
  const Vector one = hn::Set(tag, 1), zero = hn::Zero(tag);
  for (std::size_t i = 0; i < stride; i += hn::Lanes(tag)) {
    const Lanes lanes(sums + i, stride);
    const Vector sum = lanes.get(SumArrays::ScenarioSum), size = lanes.get(SumArrays::ScenarioSize),
                 positives = lanes.get(SumArrays::ScenarioPositives);
    lanes.add(SumArrays::Available, size);
    lanes.add(SumArrays::Scenarios, hn::IfThenElseZero(hn::Gt(size, zero), one));
    lanes.add_product(SumArrays::ScenarioSquaresHigh, sum, sum);
    lanes.add_product(SumArrays::ScenarioProductsHigh, sum, size);
    lanes.add_product(SumArrays::PositiveProductsHigh, sum, positives);
    lanes.add(SumArrays::SizeSquares, hn::Mul(size, size));
    lanes.add(SumArrays::Positives, positives);
    lanes.add(SumArrays::PositiveScenarios, hn::IfThenElseZero(hn::Gt(positives, zero), one));
    lanes.add(SumArrays::PositiveSquares, hn::Mul(positives, positives));
    lanes.add(SumArrays::PositiveSizes, hn::Mul(positives, size));
    for (const auto kind :
         {SumArrays::ScenarioSum, SumArrays::ScenarioSize, SumArrays::ScenarioPositives})
      lanes.set(kind, zero);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slalom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace slalom {

HWY_EXPORT(add_to_sums);
HWY_EXPORT(close_scenario_of_sums);

void add_to_sums(const double* values, std::size_t stride, double* sums) {
  HWY_DYNAMIC_DISPATCH(add_to_sums)(values, stride, sums);
}

void close_scenario_of_sums(std::size_t stride, double* sums) {
  HWY_DYNAMIC_DISPATCH(close_scenario_of_sums)(stride, sums);
}

}  // namespace slalom
#endif
