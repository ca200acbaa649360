// SPDX-License-Identifier: BSD-3-Clause
#include "center_distances.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "center_distances.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which sets the instruction set.
#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace slalom {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::CappedTag<std::uint16_t, 32>;
using Doubles = hn::CappedTag<double, 8>;
constexpr int kColumns = static_cast<int>(hn::MaxLanes(Words()));
/// Squares of larger odd numbers exceed 16 bits.
constexpr int kMaxRows = 128;
constexpr std::uint16_t kTooFar = 65535;

/// The first `count` numbers, followed by zeros.
hn::Vec<Words> load(const std::uint16_t* numbers, int count) {
  if (count == kColumns) return hn::LoadU(Words(), numbers);
  alignas(64) std::uint16_t lanes[kColumns] = {};
  std::copy_n(numbers, count, lanes);
  return hn::Load(Words(), lanes);
}

/// Squared doubled gaps within the row from `count` cell centers to the nearest occupied square,
/// at most kTooFar; the others are 0.
void fill_gaps(const std::uint16_t* to_left, const std::uint16_t* to_right, int count,
               std::uint16_t* gaps) {
  const Words words;
  const auto steps = hn::Min(load(to_left, count), load(to_right, count));
  const auto gap = hn::SaturatedSub(hn::Add(steps, steps), hn::Set(words, 1));
  const auto is_far = hn::Gt(steps, hn::Set(words, kMaxRows));
  hn::Store(hn::IfThenElse(is_far, hn::Set(words, kTooFar), hn::Mul(gap, gap)), words, gaps);
}

/// Squared doubled distances from the centers of row y of `gaps`, in which row -1 and row size_y
/// are the border. Row y +- d is 2 d - 1 away.
hn::Vec<Words> nearest_squares(const std::uint16_t* gaps, int y, int size_y) {
  const Words words;
  constexpr std::ptrdiff_t row = kColumns;
  const std::uint16_t* here = gaps + y * row;
  auto best = hn::Load(words, here);
  for (int d = 1; d <= kMaxRows; ++d) {
    const auto away = hn::Set(words, static_cast<std::uint16_t>((2 * d - 1) * (2 * d - 1)));
    if (hn::AllFalse(words, hn::Gt(best, away))) break;
    const auto above = hn::Load(words, here + std::min(d, size_y - y) * row);
    const auto below = hn::Load(words, here - std::min(d, y + 1) * row);
    best = hn::Min(best, hn::SaturatedAdd(away, hn::Min(above, below)));
  }
  return best;
}

void store_distances(const std::uint16_t* squares, int count, double resolution, float* result) {
  const Doubles real;
  const hn::Rebind<std::uint16_t, Doubles> word;
  const hn::Rebind<std::int32_t, Doubles> integer;
  const hn::Rebind<float, Doubles> single;
  alignas(64) float distances[kColumns];
  for (int i = 0; i < kColumns; i += static_cast<int>(hn::Lanes(real))) {
    const auto square = hn::PromoteTo(real, hn::PromoteTo(integer, hn::Load(word, squares + i)));
    const auto distance = hn::Mul(hn::Set(real, 0.5 * resolution), hn::Sqrt(square));
    hn::Store(hn::DemoteTo(single, distance), single, distances + i);
  }
  std::copy_n(distances, count, result);
}

bool fill_center_distances(const std::uint16_t* to_left, const std::uint16_t* to_right, int size_x,
                           int size_y, double resolution, float* distances) {
  const Words words;
  const auto buffer =
      hwy::AllocateAligned<std::uint16_t>(static_cast<std::size_t>(size_y + 2) * kColumns);
  std::uint16_t* gaps = buffer.get() + kColumns;
  std::fill_n(gaps - kColumns, kColumns, std::uint16_t{0});
  std::fill_n(gaps + static_cast<std::ptrdiff_t>(size_y) * kColumns, kColumns, std::uint16_t{0});
  for (int x = 0; x < size_x; x += kColumns) {
    const int count = std::min(kColumns, size_x - x);
    const auto at = [=](int y) { return static_cast<std::ptrdiff_t>(y) * size_x + x; };
    for (int y = 0; y < size_y; ++y)
      fill_gaps(to_left + at(y), to_right + at(y), count,
                gaps + static_cast<std::ptrdiff_t>(y) * kColumns);
    for (int y = 0; y < size_y; ++y) {
      const auto nearest = nearest_squares(gaps, y, size_y);
      if (!hn::AllFalse(words, hn::Eq(nearest, hn::Set(words, kTooFar)))) return false;
      alignas(64) std::uint16_t squares[kColumns];
      hn::Store(nearest, words, squares);
      store_distances(squares, count, resolution, distances + at(y));
    }
  }
  return true;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slalom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace slalom {

HWY_EXPORT(fill_center_distances);

bool fill_center_distances(const std::uint16_t* to_left, const std::uint16_t* to_right, int size_x,
                           int size_y, double resolution, float* distances) {
  return HWY_DYNAMIC_DISPATCH(fill_center_distances)(to_left, to_right, size_x, size_y, resolution,
                                                     distances);
}

}  // namespace slalom
#endif
