// SPDX-License-Identifier: BSD-3-Clause
#include "common/map_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/map_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which sets the instruction set.
#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace reactive {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kMaxLanes>;
using Doubles = hn::CappedTag<double, kMaxLanes / 2>;
using Singles = hn::Rebind<float, Doubles>;
using Integers = hn::Rebind<std::int32_t, Doubles>;

constexpr auto kFloatLanes = static_cast<int>(hn::MaxLanes(Floats()));

/// Cells (columns or rows) within `reach` of coordinate `x`, both in cells.
struct Interval {
  Interval(double x, double reach, int side)
      : first(std::max(0, static_cast<int>(std::ceil(x - reach)))),
        last(std::min(side - 1, static_cast<int>(std::floor(x + reach)))) {}
  int first, last;
};

/// Squared distances within a row from the columns to `x`, infinite after the last column.
void square_columns(const Interval& columns, float x, float resolution, float* squares) {
  const Floats d;
  const int count = columns.last - columns.first + 1;
  for (int i = 0; i < count; i += kFloatLanes) {
    const auto column = hn::Iota(d, static_cast<float>(columns.first + i));
    const auto dx = hn::Mul(hn::Sub(column, hn::Set(d, x)), hn::Set(d, resolution));
    const auto inside = hn::FirstN(d, static_cast<std::size_t>(count - i));
    const auto infinite = hn::Set(d, std::numeric_limits<float>::infinity());
    hn::Store(hn::IfThenElse(inside, hn::Mul(dx, dx), infinite), d, squares + i);
  }
}

/// Lowers the cells in the square around a point to their squared distances to it.
void stamp(const GridFrame& frame, double reach, const Point& p, float* squares, float* cells) {
  const Floats d;
  const double x = (p.x - frame.origin.x) / frame.resolution - 0.5;
  const double y = (p.y - frame.origin.y) / frame.resolution - 0.5;
  const Interval columns(x, reach, frame.side), rows(y, reach, frame.side);
  const int count = columns.last - columns.first + 1;
  const auto resolution = static_cast<float>(frame.resolution);
  square_columns(columns, static_cast<float>(x), resolution, squares);
  for (int row = rows.first; row <= rows.last; ++row) {
    const float dy = (static_cast<float>(row) - static_cast<float>(y)) * resolution;
    const auto dy2 = hn::Set(d, dy * dy);
    float* const at = cells + static_cast<std::ptrdiff_t>(row) * frame.side + columns.first;
    for (int i = 0; i < count; i += kFloatLanes) {
      const auto squared = hn::Add(hn::Load(d, squares + i), dy2);
      hn::StoreU(hn::Min(hn::LoadU(d, at + i), squared), d, at + i);
    }
  }
}

void fill_clearances(const GridFrame& frame, double band, const std::vector<Point>& points,
                     std::vector<float>& cells) {
  const Floats d;
  const auto count = static_cast<std::size_t>(frame.side) * static_cast<std::size_t>(frame.side);
  std::fill(cells.begin(), cells.end(), static_cast<float>(band * band));
  const auto squares = hwy::AllocateAligned<float>(padded(static_cast<std::size_t>(frame.side)));
  for (const Point& p : points)
    stamp(frame, band / frame.resolution, p, squares.get(), cells.data());
  for (std::size_t i = 0; i < count; i += kFloatLanes)
    hn::StoreU(hn::Sqrt(hn::LoadU(d, cells.data() + i)), d, cells.data() + i);
}

/// Differences are in single precision, everything else is in double precision.
void interpolate(const GridFrame& frame, double band, const float* cells, const double* xs,
                 const double* ys, std::size_t count, double* clearances) {
  const Doubles d;
  const Singles single;
  const Integers integer;
  const auto half = hn::Set(d, 0.5), resolution = hn::Set(d, frame.resolution);
  const auto last = hn::Set(d, frame.side - 1.0);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto column_of = [&](const double* at, double origin) {
      return hn::Sub(hn::Div(hn::Sub(hn::LoadU(d, at + i), hn::Set(d, origin)), resolution), half);
    };
    const auto x = column_of(xs, frame.origin.x), y = column_of(ys, frame.origin.y);
    const auto inside = hn::And(hn::And(hn::Ge(x, hn::Zero(d)), hn::Ge(y, hn::Zero(d))),
                                hn::And(hn::Lt(x, last), hn::Lt(y, last)));
    const auto column = hn::DemoteTo(integer, hn::IfThenElseZero(inside, x));
    const auto row = hn::DemoteTo(integer, hn::IfThenElseZero(inside, y));
    const auto fx = hn::Sub(x, hn::PromoteTo(d, column)), fy = hn::Sub(y, hn::PromoteTo(d, row));
    const auto cell = hn::Add(hn::Mul(row, hn::Set(integer, frame.side)), column);
    const auto along_row = [&](const float* first) {
      const auto left = hn::GatherIndex(single, first, cell);
      const auto right = hn::GatherIndex(single, first + 1, cell);
      return hn::Add(hn::PromoteTo(d, left), hn::Mul(fx, hn::PromoteTo(d, hn::Sub(right, left))));
    };
    const auto bottom = along_row(cells), top = along_row(cells + frame.side);
    const auto value = hn::Add(bottom, hn::Mul(fy, hn::Sub(top, bottom)));
    hn::StoreU(hn::IfThenElse(inside, value, hn::Set(d, band)), d, clearances + i);
  }
}

/// Weights of as many cells as a vector of doubles has.
hn::Vec<Integers> weights_of(const WeightRule& rule, const float* clearances) {
  const Doubles d;
  const auto clearance = hn::PromoteTo(d, hn::LoadU(Singles(), clearances));
  const auto ratio = hn::Div(hn::Sub(hn::Set(d, rule.comfort), clearance), hn::Set(d, rule.span));
  const auto deficit = hn::Min(hn::Max(ratio, hn::Zero(d)), hn::Set(d, 1.0));
  const auto unit = hn::Set(d, rule.unit);
  const auto extra = hn::Mul(hn::Mul(hn::Set(d, rule.slope), deficit), unit);
  const auto weight = hn::Add(hn::Floor(extra), unit);
  const auto open = hn::Ge(clearance, hn::Set(d, rule.closed));
  return hn::DemoteTo(Integers(), hn::IfThenElseZero(open, weight));
}

void fill_weights(const WeightRule& rule, const float* clearances, std::size_t count,
                  std::int32_t max_weight, std::int32_t closed_cost, std::int32_t open_cost,
                  std::int32_t* weights, std::int32_t* costs) {
  const Singles single;
  const Integers integer;
  const auto lanes = hn::Lanes(integer);
  // Most cells are beyond `comfort` and open, which needs no division.
  const double far = std::max(rule.comfort, rule.closed);
  const auto comfortable =
      hn::Set(single, std::nextafter(static_cast<float>(far), std::numeric_limits<float>::max()));
  const auto unit = hn::Set(integer, static_cast<std::int32_t>(rule.unit));
  const auto closed = hn::Set(integer, closed_cost), open = hn::Set(integer, open_cost);
  for (std::size_t i = 0; i < count; i += lanes) {
    auto weight = unit;
    if (!hn::AllTrue(single, hn::Ge(hn::LoadU(single, clearances + i), comfortable)))
      weight = hn::Min(weights_of(rule, clearances + i), hn::Set(integer, max_weight));
    hn::StoreU(weight, integer, weights + i);
    const auto is_closed = hn::Eq(weight, hn::Zero(integer));
    hn::StoreU(hn::IfThenElse(is_closed, closed, open), integer, costs + i);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace reactive
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reactive {

HWY_EXPORT(fill_clearances);
HWY_EXPORT(interpolate);
HWY_EXPORT(fill_weights);

void fill_clearances(const GridFrame& frame, double band, const std::vector<Point>& points,
                     std::vector<float>& cells) {
  HWY_DYNAMIC_DISPATCH(fill_clearances)(frame, band, points, cells);
}

void interpolate(const GridFrame& frame, double band, const float* cells, const double* x,
                 const double* y, std::size_t count, double* clearances) {
  HWY_DYNAMIC_DISPATCH(interpolate)(frame, band, cells, x, y, count, clearances);
}

void fill_weights(const WeightRule& rule, const float* clearances, std::size_t count,
                  std::int32_t max_weight, std::int32_t closed_cost, std::int32_t open_cost,
                  std::int32_t* weights, std::int32_t* costs) {
  HWY_DYNAMIC_DISPATCH(fill_weights)
  (rule, clearances, count, max_weight, closed_cost, open_cost, weights, costs);
}

}  // namespace reactive
#endif
