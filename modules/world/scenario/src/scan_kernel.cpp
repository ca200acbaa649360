// SPDX-License-Identifier: BSD-3-Clause
#include "rectangle_codes.h"
#include "scan_kernel.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scan_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which sets the instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace slalom {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Reals = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Reals>;
using Codes = hn::Rebind<std::uint8_t, Ints>;
using Doubles = hn::CappedTag<double, 8>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Reals()));
constexpr int kDoubleLanes = static_cast<int>(hn::MaxLanes(Doubles()));

/// Adding 2^23 to a small natural number makes its float the number itself, plus 0x4B000000.
constexpr float kShift = 8388608.0F;
constexpr std::uint32_t kShiftBits = 0x4B000000;

/// A vector of rays, each in the frame mirrored so that it goes up and to the right, relative to
/// the origin's cell, in cells.
///
/// Why the walk is certain. Let u = 2^-24 be the unit of rounding, dx > 0 the exact direction, L
/// the largest t or coordinate met before a ray stops (at most limit + 2), X the column at which a
/// ray leaves its rectangle and T = (X - x) / dx. Rounded are the origin x (error u / 2), dx and
/// its inverse (relative u each, so per_x 2 u), t_of_x = x per_x (u per_x), the product X per_x (u
/// (T + per_x), where it is not fused) and the difference (u T). So tx is off by at most 4 u T
/// + 2.5 u per_x, and likewise ty.
///
/// `other`, the coordinate at t = tx along the other axis, adds errors of dy (u T), of a product (u
/// T), of a sum (u L) and of the origin (0.75 u): it is off by at most e = 7 u L + 3.25 u
/// max(per_x, per_y). `margin` and `reach` use e' = 11.7 u (limit + 2) + 3.3 u max(per_x, per_y),
/// which is more than e by what rounding them may take. (1) Where `other` is more than e' from an
/// integer, its cell is that of the exact ray. (2) The face is right, too. Say the ray seems to
/// leave through a column: tx < ty. With the exact row Y at which the rectangle ends, ty dy + y is
/// off from Y by at most 6 u L, as dy per_y is 1 up to u; and because rounded products with dy >= 0
/// and rounded sums are monotone, `other` computed from tx is not larger than that computed from
/// ty. So it is at most Y + 6 u L < Y + e'; if it is certain, its cell is below Y, and by (1) the
/// exact ray crosses the column below Y. By the same argument, the later of the two crossings into
/// the last cell is the face that was hit. (3) The ray stops at t >= reach = limit + e' only if T
/// >= limit: all before was free. Rays almost parallel to an axis have e' > 0.5, and are never
/// certain.
struct alignas(64) RayVector {
  float dx[kLanes], dy[kLanes];          ///< directions, not negative
  float per_x[kLanes], per_y[kLanes];    ///< their inverses
  float x[kLanes], y[kLanes];            ///< origins minus a half: rounding gives cells
  float t_of_x[kLanes], t_of_y[kLanes];  ///< origins times inverses of directions
  float margin[kLanes];  ///< distance from the center of a cell that is certain; 0: ray stopped
  float reach[kLanes];   ///< at this t the limit is certainly reached
  std::int32_t first[kLanes];
  // The ray's cell relative to the origin's, its index in the table, its codes, and where the ray
  // leaves the rectangle.
  float cx[kLanes], cy[kLanes];
  std::int32_t at[kLanes];
  float exit[kLanes];
  std::uint8_t codes[kLanes];
};

constexpr int kMaxVectors = RayChunk::kSize / kLanes;

/// Directions in the world: to `rays` and, in single precision, to `vectors`.
void rotate(const ScanOrigin& origin, const double* cosine, const double* sine, int count,
            RayVector* vectors, RayChunk& rays) {
  const Doubles real;
  const hn::Rebind<float, Doubles> single;
  const auto c = hn::Set(real, origin.cosine), s = hn::Set(real, origin.sine);
  for (int i = 0; i < count; i += kDoubleLanes) {
    const auto along = hn::LoadU(real, cosine + i), across = hn::LoadU(real, sine + i);
    const auto x = hn::Sub(hn::Mul(c, along), hn::Mul(s, across));
    const auto y = hn::Add(hn::Mul(s, along), hn::Mul(c, across));
    hn::Store(x, real, rays.cosine + i);
    hn::Store(y, real, rays.sine + i);
    hn::Store(hn::DemoteTo(single, x), single, vectors[i / kLanes].dx + i % kLanes);
    hn::Store(hn::DemoteTo(single, y), single, vectors[i / kLanes].dy + i % kLanes);
  }
}

/// Numbers of the origin that all rays need, for both mirrored frames.
struct Frames {
  hn::Vec<Reals> x[2], y[2], limit, error;
  hn::Vec<Ints> column[2], row[2], codes[2][2];

  explicit Frames(const ScanOrigin& origin) {
    const auto stride = static_cast<std::uint32_t>(origin.stride);
    const std::uint32_t bits = kShiftBits + kShiftBits * stride;
    for (const int mirrored : {0, 1}) {
      x[mirrored] = within_cell(origin.x[mirrored]);
      y[mirrored] = within_cell(origin.y[mirrored]);
      const auto column_bits = static_cast<std::uint32_t>(origin.column[mirrored]) - bits;
      column[mirrored] = hn::Set(Ints(), static_cast<std::int32_t>(column_bits));
      row[mirrored] = hn::Set(Ints(), origin.row[mirrored]);
      for (const int down : {0, 1})
        codes[mirrored][down] = hn::Set(Ints(), origin.codes[mirrored][down]);
    }
    const double size = static_cast<double>(origin.size_x) + origin.size_y;  // no ray is longer
    const float max_range = static_cast<float>(std::min(origin.limit, size));
    limit = hn::Set(Reals(), max_range);
    error = hn::Set(Reals(), 7e-7F * (max_range + 2));
  }
  static hn::Vec<Reals> within_cell(double x) {
    return hn::Set(Reals(), static_cast<float>(x - std::floor(x)));
  }
};

/// Completes a vector with the directions in it. The small summand keeps inverses finite.
void prepare(const Frames& frames, RayVector& rays) {
  const Reals real;
  const Ints integer;
  const auto tiny = hn::Set(real, 1e-20F), half = hn::Set(real, 0.5F), zero = hn::Zero(real);
  const auto cosine = hn::Load(real, rays.dx), sine = hn::Load(real, rays.dy);
  const auto left = hn::Lt(cosine, zero), down = hn::Lt(sine, zero);
  const auto dx = hn::Abs(cosine), dy = hn::Abs(sine);
  const auto per_x = hn::Div(hn::Set(real, 1), hn::Add(dx, tiny));
  const auto per_y = hn::Div(hn::Set(real, 1), hn::Add(dy, tiny));
  const auto x = hn::IfThenElse(left, frames.x[1], frames.x[0]);
  const auto y = hn::IfThenElse(down, frames.y[1], frames.y[0]);
  const auto error = hn::MulAdd(hn::Set(real, 2e-7F), hn::Max(per_x, per_y), frames.error);
  const auto to_left = hn::RebindMask(integer, left), to_down = hn::RebindMask(integer, down);
  const auto column = hn::IfThenElse(to_left, frames.column[1], frames.column[0]);
  const auto row = hn::IfThenElse(to_down, frames.row[1], frames.row[0]);
  const auto codes_left = hn::IfThenElse(to_down, frames.codes[1][1], frames.codes[1][0]);
  const auto codes_right = hn::IfThenElse(to_down, frames.codes[0][1], frames.codes[0][0]);
  const auto codes = hn::IfThenElse(to_left, codes_left, codes_right);
  hn::Store(dx, real, rays.dx);
  hn::Store(dy, real, rays.dy);
  hn::Store(per_x, real, rays.per_x);
  hn::Store(per_y, real, rays.per_y);
  hn::Store(hn::Sub(x, half), real, rays.x);
  hn::Store(hn::Sub(y, half), real, rays.y);
  hn::Store(hn::Mul(x, per_x), real, rays.t_of_x);
  hn::Store(hn::Mul(y, per_y), real, rays.t_of_y);
  hn::Store(hn::Sub(half, error), real, rays.margin);
  hn::Store(hn::Add(frames.limit, error), real, rays.reach);
  hn::Store(hn::Add(column, row), integer, rays.first);
  hn::Store(hn::DemoteTo(Codes(), codes), Codes(), rays.codes);
  hn::Store(zero, real, rays.cx);
  hn::Store(zero, real, rays.cy);
}

/// Gathers the codes of the cells: faster by loads than by the instructions for it.
HWY_INLINE void look_up(const std::uint8_t* rectangles, RayVector& rays) {
  for (int i = 0; i < kLanes; ++i)
    rays.codes[i] = rectangles[static_cast<std::uint32_t>(rays.at[i])];
}

HWY_INLINE hn::Vec<Ints> codes_of(const RayVector& rays) {
  return hn::PromoteTo(Ints(), hn::Load(Codes(), rays.codes));
}

HWY_INLINE hn::Vec<Reals> extents_of(hn::Vec<Ints> codes) {
  const Ints integer;
#if HWY_TARGET == HWY_SCALAR
  const auto extents = hn::Set(integer, kExtents[static_cast<std::size_t>(hn::GetLane(codes))]);
#else
  const hn::Repartition<std::uint8_t, Ints> bytes;
  const auto table = hn::LoadDup128(bytes, kExtents.data());
  const auto extents = hn::BitCast(integer, hn::TableLookupBytes(table, hn::BitCast(bytes, codes)));
#endif
  return hn::ConvertTo(Reals(), extents);
}

/// Leaves the free rectangle at each ray's cell through one of its far faces, unless the cell is
/// occupied, the limit is reached or the next cell uncertain. False when all rays have stopped.
HWY_INLINE bool step(std::int32_t stride, RayVector& rays) {
  const Reals real;
  const Ints integer;
  const auto codes = codes_of(rays);
  const auto width = hn::And(codes, hn::Set(integer, 15)), height = hn::ShiftRight<4>(codes);
  const auto cx = hn::Load(real, rays.cx), cy = hn::Load(real, rays.cy);
  const auto far_x = hn::Add(cx, extents_of(width)), far_y = hn::Add(cy, extents_of(height));
  const auto tx = hn::MulSub(far_x, hn::Load(real, rays.per_x), hn::Load(real, rays.t_of_x));
  const auto ty = hn::MulSub(far_y, hn::Load(real, rays.per_y), hn::Load(real, rays.t_of_y));
  const auto t = hn::Min(tx, ty);
  const auto through_x = hn::Lt(tx, ty);
  const auto x = hn::MulAdd(t, hn::Load(real, rays.dx), hn::Load(real, rays.x));
  const auto y = hn::MulAdd(t, hn::Load(real, rays.dy), hn::Load(real, rays.y));
  const auto other = hn::IfThenElse(through_x, y, x);
  const auto cell = hn::Round(other);
  const auto off_center = hn::Abs(hn::Sub(other, cell));
  const auto margin = hn::Load(real, rays.margin);
  const auto certain = hn::And(hn::Lt(off_center, margin), hn::Lt(t, hn::Load(real, rays.reach)));
  const auto runs = hn::And(hn::RebindMask(real, hn::Ne(width, hn::Zero(integer))), certain);
  const auto next_x = hn::IfThenElse(runs, hn::IfThenElse(through_x, far_x, cell), cx);
  const auto next_y = hn::IfThenElse(runs, hn::IfThenElse(through_x, cell, far_y), cy);
  const auto shift = hn::Set(real, kShift);
  const auto column = hn::BitCast(integer, hn::Add(next_x, shift));
  const auto row = hn::Mul(hn::BitCast(integer, hn::Add(next_y, shift)), hn::Set(integer, stride));
  hn::Store(next_x, real, rays.cx);
  hn::Store(next_y, real, rays.cy);
  hn::Store(t, real, rays.exit);
  hn::Store(hn::IfThenElseZero(runs, margin), real, rays.margin);
  hn::Store(hn::Add(hn::Add(column, hn::Load(integer, rays.first)), row), integer, rays.at);
  return !hn::AllFalse(real, runs);
}

/// Walks until all rays have stopped, in rounds over the vectors with rays that have not: these do
/// not wait for each other's memory.
void walk(const ScanOrigin& origin, int count, RayVector* vectors) {
  int active[kMaxVectors];
  for (int i = 0; i < count; ++i) active[i] = i;
  while (true) {
    int next = 0;
    for (int i = 0; i < count; ++i) {
      const int vector = active[i];
      active[next] = vector;
      next += step(origin.stride, vectors[vector]) ? 1 : 0;
    }
    if (next == 0) return;
    count = next;
    for (int i = 0; i < count; ++i) look_up(origin.rectangles, vectors[active[i]]);
  }
}

/// The face of a hit cell is the one that the ray crossed last.
void find_faces(const RayVector& rays, std::int32_t* faces) {
  const Reals real;
  const Ints integer;
  const auto cx = hn::Load(real, rays.cx), cy = hn::Load(real, rays.cy);
  const auto tx = hn::MulSub(cx, hn::Load(real, rays.per_x), hn::Load(real, rays.t_of_x));
  const auto ty = hn::MulSub(cy, hn::Load(real, rays.per_y), hn::Load(real, rays.t_of_y));
  const auto face = hn::NearestInt(hn::IfThenElse(hn::Gt(tx, ty), cx, hn::Neg(cy)));
  const auto hit = hn::Eq(codes_of(rays), hn::Zero(integer));
  const auto beyond = hn::Ge(hn::Load(real, rays.exit), hn::Load(real, rays.reach));
  const auto open =
      hn::IfThenElse(hn::RebindMask(integer, beyond), hn::Set(integer, RayChunk::kNothing),
                     hn::Set(integer, RayChunk::kUndecided));
  hn::Store(hn::IfThenElse(hit, face, open), integer, faces);
}

/// Computes the range to each face in double precision; true if some rays are undecided.
bool measure(const ScanOrigin& origin, int count, RayChunk& rays) {
  const Doubles real;
  const hn::Rebind<float, Doubles> single;
  const hn::Rebind<std::int32_t, Doubles> integer;
  const auto set = [=](double x) { return hn::Set(real, x); };
  const auto zero = hn::Zero(real), limit = set(origin.limit), max_range = set(origin.max_range);
  const auto x0 = set(origin.x[0]), x1 = set(origin.x[1]), column0 = hn::Floor(x0),
             column1 = hn::Floor(x1);
  const auto y0 = set(origin.y[0]), y1 = set(origin.y[1]), row0 = hn::Floor(y0),
             row1 = hn::Floor(y1);
  const auto resolution = set(origin.resolution);
  auto uncertain = hn::Lt(zero, zero);
  for (int i = 0; i < count; i += kDoubleLanes) {
    const auto cosine = hn::Load(real, rays.cosine + i), sine = hn::Load(real, rays.sine + i);
    const auto face = hn::PromoteTo(real, hn::Load(integer, rays.face + i));
    const auto left = hn::Lt(cosine, zero), down = hn::Lt(sine, zero);
    const auto by_column = hn::Gt(face, zero);
    const auto cell = hn::IfThenElse(by_column, hn::IfThenElse(left, column1, column0),
                                     hn::IfThenElse(down, row1, row0));
    const auto start =
        hn::IfThenElse(by_column, hn::IfThenElse(left, x1, x0), hn::IfThenElse(down, y1, y0));
    const auto direction = hn::Abs(hn::IfThenElse(by_column, cosine, sine));
    const auto distance = hn::Sub(hn::Add(cell, hn::Abs(face)), start);
    const auto t = hn::Mul(distance, hn::Div(set(1), direction));
    const auto hits = hn::And(hn::Ne(face, set(RayChunk::kNothing)), hn::Lt(t, limit));
    const auto range = hn::Mul(resolution, hn::IfThenElse(hits, t, limit));
    const auto undecided = hn::Eq(face, set(RayChunk::kUndecided));
    const auto result =
        hn::IfThenElse(undecided, set(RayChunk::kUncertain), hn::Min(max_range, range));
    hn::Store(hn::DemoteTo(single, result), single, rays.range + i);
    uncertain = hn::Or(uncertain, undecided);
  }
  return !hn::AllFalse(real, uncertain);
}

bool cast_rays(const ScanOrigin& origin, const double* cosine, const double* sine, int count,
               RayChunk& rays) {
  static_assert(RayChunk::kSize % kLanes == 0, "chunks of complete vectors");
  RayVector vectors[kMaxVectors];
  const int vector_count = (count + kLanes - 1) / kLanes, end = vector_count * kLanes;
  rotate(origin, cosine, sine, end, vectors, rays);
  const Frames frames(origin);
  for (int i = 0; i < vector_count; ++i) prepare(frames, vectors[i]);
  if (origin.rectangles == nullptr) {
    std::fill_n(rays.face, end, RayChunk::kUndecided);
  } else {
    walk(origin, vector_count, vectors);
    for (int i = 0; i < vector_count; ++i)
      find_faces(vectors[i], rays.face + std::ptrdiff_t{i} * kLanes);
  }
  return measure(origin, end, rays);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slalom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace slalom {

HWY_EXPORT(cast_rays);

bool cast_rays(const ScanOrigin& origin, const double* cosine, const double* sine, int count,
               RayChunk& rays) {
  return HWY_DYNAMIC_DISPATCH(cast_rays)(origin, cosine, sine, count, rays);
}

}  // namespace slalom
#endif
