// SPDX-License-Identifier: BSD-3-Clause
#include "common/map_kernels.h"
#include "common/wavefront.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/wavefront.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which sets the instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace reactive {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Integers = hn::CappedTag<std::int32_t, 4>;

constexpr std::int32_t kAcross = Wavefront::kDiagonal, kAlong = Wavefront::kStraight;
/// Costs of the steps to the three cells of the row above or below, and of the same row; the steps
/// to the cell itself and to a fourth cell are ignored.
alignas(16) constexpr std::int32_t kOtherRow[] = {kAcross, kAlong, kAcross, 0};
alignas(16) constexpr std::int32_t kSameRow[] = {kAlong, kAlong, kAlong, 0};

/// Bits 0 to 2: whether steps from a cell of this cost improve the three cells that begin at
/// `first`.
HWY_INLINE unsigned improved_cells(const Wavefront& front, std::int32_t cost, std::size_t first,
                                   const std::int32_t* steps) {
  const Integers d;
  const auto from = hn::Set(d, cost);
  unsigned result = 0;
  for (std::size_t i = 0; i < 3; i += hn::Lanes(d)) {
    const auto weight = hn::LoadU(d, &front.weights[first + i]);
    const auto via = hn::Add(from, hn::Mul(weight, hn::Load(d, steps + i)));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Lt(via, hn::LoadU(d, &front.costs[first + i])), bits);
    result |= static_cast<unsigned>(bits[0]) << i;
  }
  return result & 7U;
}

HWY_INLINE void expand(const Wavefront::Entry& entry, Wavefront& front) {
  for (const int row : {-1, 0, 1}) {
    const auto first = static_cast<std::size_t>(entry.cell + row * front.side - 1);
    const std::int32_t* const steps = row == 0 ? kSameRow : kOtherRow;
    unsigned improved = improved_cells(front, entry.cost, first, steps);
    for (std::size_t i = 0; improved != 0; improved >>= 1U, ++i)
      if ((improved & 1U) != 0)
        front.improve(first + i, entry.cost + steps[i] * front.weights[first + i]);
  }
}

void spread(std::size_t target, std::size_t end, Wavefront& front) {
  for (; front.next_bucket < std::min(end, front.buckets.size()); ++front.next_bucket) {
    const std::int32_t cost = front.costs[target];
    if (cost != Wavefront::kBlocked && front.is_final(cost)) return;
    // A step towards what is ahead can append to the same bucket.
    for (std::size_t i = 0; i < front.buckets[front.next_bucket].size(); ++i) {
      const Wavefront::Entry entry = front.buckets[front.next_bucket][i];
      if (entry.cost == front.costs[static_cast<std::size_t>(entry.cell)]) expand(entry, front);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace reactive
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reactive {

HWY_EXPORT(spread);

void Wavefront::spread_to(std::size_t target) {
  HWY_DYNAMIC_DISPATCH(spread)(target, buckets.max_size(), *this);
}

void Wavefront::spread_before(std::size_t end) {
  const std::size_t unused = costs.size() - 1;  // its cost is never final
  HWY_DYNAMIC_DISPATCH(spread)(unused, end, *this);
}

void Wavefront::clear() {
  for (auto& bucket : buckets) bucket.clear();
  next_bucket = 0;
}

void Wavefront::resize(int cells_per_side) {
  side = cells_per_side;
  const auto cells = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  for (auto* column : {&costs, &weights, &ahead})
    column->assign(padded(cells) + kMaxLanes, kUnreached);
}

}  // namespace reactive
#endif
