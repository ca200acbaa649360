// SPDX-License-Identifier: BSD-3-Clause
#include "free_rectangles.h"
#include "rectangle_codes.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "free_rectangles.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which sets the instruction set.
#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace slalom {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::CappedTag<std::uint8_t, 64>;
using SignedBytes = hn::CappedTag<std::int8_t, 64>;
constexpr int kColumns = static_cast<int>(hn::MaxLanes(Bytes()));

using Buffer = hwy::AlignedFreeUniquePtr<std::uint8_t[]>;

Buffer zeros(std::size_t count) {
  Buffer buffer = hwy::AllocateAligned<std::uint8_t>(count);
  std::fill_n(buffer.get(), count, std::uint8_t{0});
  return buffer;
}

/// The codes of the free runs that begin at the cells of each row, in complete vectors.
class Runs {
 public:
  Runs(int size_x, int size_y)
      : size_x_(size_x),
        padded_((static_cast<std::size_t>(size_x) + kColumns - 1) / kColumns * kColumns),
        free_stride_(padded_ + kExtents.back()),
        codes_(zeros(padded_ * static_cast<std::size_t>(size_y))),
        free_(zeros(kCodes * free_stride_ + kColumns)) {}

  const std::uint8_t* row(int y) const {
    return codes_.get() + padded_ * static_cast<std::size_t>(y);
  }

  void fill(const std::uint8_t* cells, bool left, int y) {
    std::uint8_t* free = free_of(1);
    if (left)
      for (int x = 0; x < size_x_; ++x) free[x] = cells[size_x_ - 1 - x] == 0 ? 1 : 0;
    else
      for (int x = 0; x < size_x_; ++x) free[x] = cells[x] == 0 ? 1 : 0;
    std::uint8_t* codes = codes_.get() + padded_ * static_cast<std::size_t>(y);
    std::copy_n(free, padded_, codes);
    for (std::size_t code = 2; code < kCodes; ++code) count_free(code, codes);
  }

 private:
  /// For each cell 1 where a run of this extent is free, followed by zeros.
  std::uint8_t* free_of(std::size_t code) { return free_.get() + code * free_stride_; }

  void count_free(std::size_t code, std::uint8_t* codes) {
    const Bytes bytes;
    const std::uint8_t* first = free_of(kDoublings[code].half);
    const std::uint8_t* second = first + kDoublings[code].offset;
    std::uint8_t* result = free_of(code);
    for (std::size_t x = 0; x < padded_; x += kColumns) {
      const auto free = hn::And(hn::LoadU(bytes, first + x), hn::LoadU(bytes, second + x));
      hn::StoreU(free, bytes, result + x);
      hn::Store(hn::Add(hn::Load(bytes, codes + x), free), bytes, codes + x);
    }
  }

  int size_x_;
  std::size_t padded_, free_stride_;
  Buffer codes_, free_;
};

/// The scores of rectangles of one height with these codes of width.
HWY_INLINE hn::Vec<SignedBytes> scores_of(const std::int8_t* scores, hn::Vec<Bytes> widths) {
  const SignedBytes integer;
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(integer, scores[hn::GetLane(widths)]);
#else
  return hn::TableLookupBytes(hn::LoadDup128(integer, scores), hn::BitCast(integer, widths));
#endif
}

/// A strip of columns, filled from the top row: for each extent of height the codes of the widths
/// of the free rectangles of that height, in the last rows.
class Strip {
 public:
  explicit Strip(const RectangleScores& scores)
      : scores_(scores), widths_(zeros(kAllRows * kColumns)) {}
  void clear() { std::fill_n(widths_.get(), kAllRows * kColumns, std::uint8_t{0}); }

  /// The best rectangles of the next row; `number` is the number of rows before.
  HWY_INLINE hn::Vec<Bytes> add_row(hn::Vec<Bytes> runs, unsigned number) {
    const Bytes bytes;
    hn::Store(runs, bytes, row<1>(number));
    const auto free = hn::Ne(runs, hn::Zero(bytes));
    auto best = hn::Or(runs, hn::IfThenElseZero(free, hn::Set(bytes, 16)));
    auto score = scores_of(scores_.score[1], runs);
    add_heights(number, best, score, std::make_index_sequence<kCodes - 2>());
    return best;
  }

 private:
  template <std::size_t... kIndex>
  HWY_INLINE void add_heights(unsigned number, hn::Vec<Bytes>& best, hn::Vec<SignedBytes>& score,
                              std::index_sequence<kIndex...>) {
    (add_height<kIndex + 2>(number, best, score), ...);
  }

  template <std::size_t kCode>
  HWY_INLINE void add_height(unsigned number, hn::Vec<Bytes>& best, hn::Vec<SignedBytes>& score) {
    const Bytes bytes;
    constexpr Doubling kDoubling = kDoublings[kCode];
    const unsigned above = number - static_cast<unsigned>(kDoubling.offset);
    const auto width = hn::Min(hn::Load(bytes, row<kDoubling.half>(number)),
                               hn::Load(bytes, row<kDoubling.half>(above)));
    hn::Store(width, bytes, row<kCode>(number));
    const auto this_score = scores_of(scores_.score[kCode], width);
    const auto better = hn::RebindMask(bytes, hn::Gt(this_score, score));
    const auto height = hn::Set(bytes, static_cast<std::uint8_t>(16 * kCode));
    score = hn::Max(score, this_score);
    best = hn::IfThenElse(better, hn::Or(width, height), best);
  }

  template <std::size_t kCode>
  HWY_INLINE std::uint8_t* row(unsigned number) {
    constexpr unsigned kLast = kept_rows(kCode) - 1;
    constexpr std::size_t kFirst = first_row(kCode);  // computed once also without optimization
    return widths_.get() + (kFirst + (number & kLast)) * kColumns;
  }

  const RectangleScores& scores_;
  Buffer widths_;
};

void fill(const RectangleScores& scores, const std::uint8_t* cells, int size_x, int size_y,
          bool left, bool down, std::ptrdiff_t stride, std::uint8_t* rectangles) {
  const Bytes bytes;
  Runs runs(size_x, size_y);
  for (int y = 0; y < size_y; ++y)
    runs.fill(cells + static_cast<std::ptrdiff_t>(down ? size_y - 1 - y : y) * size_x, left, y);
  Strip strip(scores);
  alignas(64) std::uint8_t best[kColumns];
  for (int x = 0; x < size_x; x += kColumns) {
    strip.clear();
    for (int y = size_y - 1; y >= 0; --y) {
      const auto codes = hn::Load(bytes, runs.row(y) + x);
      const auto row = strip.add_row(codes, static_cast<unsigned>(size_y - 1 - y));
      std::uint8_t* result = rectangles + y * stride + x;
      if (x + kColumns <= size_x) {
        hn::StoreU(row, bytes, result);
      } else {
        hn::Store(row, bytes, best);
        std::copy_n(best, size_x - x, result);
      }
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slalom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace slalom {

HWY_EXPORT(fill);

namespace {

/// Mean over directions of the logarithm of the distance from the middle of the lower left cell to
/// the far faces.
double mean_log_exit(double width, double height) {
  constexpr int kDirections = 64;
  double sum = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = (i + 0.5) * 0.5 * M_PI / kDirections;
    sum += math::log(std::min((width - 0.5) / math::cos(angle), (height - 0.5) / math::sin(angle)));
  }
  return sum / kDirections;
}

}  // namespace

RectangleScores::RectangleScores() {
  const double least = mean_log_exit(1, 1);
  const double range = mean_log_exit(kExtents.back(), kExtents.back()) - least;
  for (std::size_t height = 1; height < kCodes; ++height)
    for (std::size_t width = 1; width < kCodes; ++width) {
      const double above_least = mean_log_exit(kExtents[width], kExtents[height]) - least;
      score[height][width] = static_cast<std::int8_t>(1 + std::lround(126 * above_least / range));
    }
}

void fill_free_rectangles(const std::uint8_t* cells, int size_x, int size_y, bool left, bool down,
                          std::ptrdiff_t stride, std::uint8_t* rectangles) {
  static const RectangleScores scores;
  HWY_DYNAMIC_DISPATCH(fill)(scores, cells, size_x, size_y, left, down, stride, rectangles);
}

}  // namespace slalom
#endif
