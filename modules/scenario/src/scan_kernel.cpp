#include "scan_kernel.h"

#include <cmath>

// Vectors of unknown size cannot be members of a struct.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
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

/// Transforms each ray to its mirrored frame, in single precision relative to the origin's cell.
/// The small summand keeps the inverse finite for rays parallel to an axis, which the caller casts.
void prepare(const ScanOrigin& origin, int count, RayChunk& rays) {
  const auto within_cell = [](double x) { return static_cast<float>(x - static_cast<int>(x)); };
  const float x[] = {within_cell(origin.x[0]), within_cell(origin.x[1])};
  const float y[] = {within_cell(origin.y[0]), within_cell(origin.y[1])};
  const std::int32_t column[] = {origin.column[0], origin.column[1]};
  const std::int32_t row[] = {origin.row[0], origin.row[1]};
  for (int i = 0; i < count; ++i) {
    const float cosine = static_cast<float>(rays.cosine[i]);
    rays.dx[i] = std::abs(cosine);
    rays.per_x[i] = 1 / (std::abs(cosine) + 1e-20F);
    rays.x[i] = cosine < 0 ? x[1] : x[0];
    rays.cell[i] = cosine < 0 ? column[1] : column[0];
  }
  for (int i = 0; i < count; ++i) {
    const float sine = static_cast<float>(rays.sine[i]);
    rays.dy[i] = std::abs(sine);
    rays.per_y[i] = 1 / (std::abs(sine) + 1e-20F);
    rays.y[i] = sine < 0 ? y[1] : y[0];
    rays.cell[i] += sine < 0 ? row[1] : row[0];
  }
}

/// The state of a vector of rays. A ray stops when it hits a cell, is undecided or exceeds the
/// limit.
///
/// Error of a crossing: with e = 2^-24, x is off by e / 2, its difference to a face X, per_x
/// (twice) and their product by e of their size each, so t by at most e / 2 per_x + 4 e t, and the
/// other coordinate by that and by three roundings of its own, in all at most 3e-8 per_x + 4.2e-7
/// (limit + 2). `margin` and `reach` allow for more: the side of a cell border, and with it the
/// complete traversal, is certain.
struct RayLanes {
  hn::Vec<Reals> x, y, dx, dy, per_x, per_y, margin, reach;
  hn::Vec<Ints> first, cx, cy,
      at;  // first and at: offsets in bytes; cx, cy: from the origin's cell
  hn::Mask<Ints> running;
  int begin;

  HWY_INLINE void load(const ScanOrigin& origin, const RayChunk& rays, int i) {
    const Reals real;
    const Ints integer;
    begin = i;
    x = hn::Load(real, rays.x + i);
    y = hn::Load(real, rays.y + i);
    dx = hn::Load(real, rays.dx + i);
    dy = hn::Load(real, rays.dy + i);
    per_x = hn::Load(real, rays.per_x + i);
    per_y = hn::Load(real, rays.per_y + i);
    const auto limit = hn::Set(real, static_cast<float>(origin.limit));
    const auto error = hn::Add(hn::Mul(hn::Set(real, 1e-7F), hn::Max(per_x, per_y)),
                               hn::Mul(hn::Set(real, 7e-7F), hn::Add(limit, hn::Set(real, 2.0F))));
    margin = hn::Sub(hn::Set(real, 0.5F), error);
    reach = hn::Add(limit, error);
    first = hn::Load(integer, rays.cell + i);
    first = hn::Add(first, first);
    at = first;
    cx = cy = hn::Zero(integer);
    running = hn::Eq(cx, cx);
  }

  HWY_INLINE hn::Vec<Ints> free_square(const ScanOrigin& origin) const {
    const auto* words = reinterpret_cast<const std::int32_t*>(origin.squares);
    return hn::And(hn::GatherOffset(Ints(), words, at), hn::Set(Ints(), 0xFFFF));
  }
  HWY_INLINE hn::Vec<Reals> t_at_column(hn::Vec<Ints> column) const {
    return hn::Mul(hn::Sub(hn::ConvertTo(Reals(), column), x), per_x);
  }
  HWY_INLINE hn::Vec<Reals> t_at_row(hn::Vec<Ints> row) const {
    return hn::Mul(hn::Sub(hn::ConvertTo(Reals(), row), y), per_y);
  }

  /// Leaves the free square at each ray's cell through one of its far faces.
  HWY_INLINE void step(const ScanOrigin& origin) {
    const Reals real;
    const Ints integer;
    const auto free = free_square(origin);
    const auto far_x = hn::Add(cx, free), far_y = hn::Add(cy, free);
    const auto tx = t_at_column(far_x), ty = t_at_row(far_y);
    const auto t = hn::Min(tx, ty);
    const auto through_x = hn::Lt(tx, ty);
    const auto other =
        hn::Add(hn::IfThenElse(through_x, y, x), hn::Mul(t, hn::IfThenElse(through_x, dy, dx)));
    // Adding 2^23 rounds to an integer: other + 0.5 to the cell's number + 1, if decided.
    const auto shift = hn::Set(real, 8388608.0F);
    const auto middle = hn::Add(other, hn::Set(real, 0.5F));
    const auto shifted = hn::Add(middle, shift);
    const auto off_center = hn::Abs(hn::Sub(middle, hn::Sub(shifted, shift)));
    const auto other_cell = hn::Sub(hn::BitCast(integer, shifted), hn::Set(integer, 0x4B000001));
    const auto continues = hn::And(hn::Lt(off_center, margin), hn::Lt(t, reach));
    running = hn::And(hn::And(running, hn::Ne(free, hn::Zero(integer))),
                      hn::RebindMask(integer, continues));
    const auto column = hn::RebindMask(integer, through_x);
    cx = hn::IfThenElse(running, hn::IfThenElse(column, far_x, other_cell), cx);
    cy = hn::IfThenElse(running, hn::IfThenElse(column, other_cell, far_y), cy);
    const auto rows = hn::Mul(cy, hn::Set(integer, 2 * origin.stride));
    at = hn::Add(hn::Add(first, rows), hn::Add(cx, cx));
  }

  /// The face of a hit cell is the one that the ray crossed last.
  HWY_INLINE void store(const ScanOrigin& origin, RayChunk& rays) const {
    const Ints integer;
    const auto free = free_square(origin);
    const auto hit = hn::Eq(free, hn::Zero(integer));
    const auto by_column = hn::RebindMask(integer, hn::Gt(t_at_column(cx), t_at_row(cy)));
    const auto far_t = hn::Min(t_at_column(hn::Add(cx, free)), t_at_row(hn::Add(cy, free)));
    const auto beyond = hn::RebindMask(integer, hn::Ge(far_t, reach));
    const auto open = hn::IfThenElse(beyond, hn::Set(integer, RayChunk::kNothing),
                                     hn::Set(integer, RayChunk::kUndecided));
    const auto face = hn::IfThenElse(by_column, cx, hn::Neg(cy));
    hn::Store(hn::IfThenElse(hit, face, open), integer, rays.face + begin);
  }
};

/// The chunk's vectors, assigned to lanes as these become free.
class Queue {
 public:
  Queue(const ScanOrigin& origin, int count, RayChunk& rays)
      : origin_(origin), rays_(rays), lanes_(static_cast<int>(hn::Lanes(Ints()))) {
    end_ = (count + lanes_ - 1) / lanes_ * lanes_;
    open_ = end_ / lanes_;
  }
  int end() const { return end_; }
  bool empty() const { return open_ == 0; }

  HWY_INLINE void start(RayLanes& lanes) {
    lanes.load(origin_, rays_, next_ < end_ ? next_ : 0);
    if (next_ >= end_) lanes.begin = -1;
    next_ += lanes_;
  }
  HWY_INLINE void step(RayLanes& lanes) {
    lanes.step(origin_);
    if (!hn::AllFalse(Ints(), lanes.running) || lanes.begin < 0) return;
    lanes.store(origin_, rays_);
    --open_;
    start(lanes);
  }

 private:
  const ScanOrigin& origin_;
  RayChunk& rays_;
  int lanes_, end_ = 0, next_ = 0, open_ = 0;
};

/// Computes the range (cells) to each face in double precision.
void measure(const ScanOrigin& origin, int count, RayChunk& rays) {
  const double x[] = {origin.x[0], origin.x[1]}, y[] = {origin.y[0], origin.y[1]};
  const double cell_x[] = {std::floor(x[0]), std::floor(x[1])};
  const double cell_y[] = {std::floor(y[0]), std::floor(y[1])};
  const double limit = origin.limit;
  for (int i = 0; i < count; ++i) {
    const bool left = rays.cosine[i] < 0, down = rays.sine[i]<0, by_column = rays.face[i]> 0;
    const double steps = std::abs(static_cast<double>(rays.face[i]));
    const double dx = std::abs(rays.cosine[i]), dy = std::abs(rays.sine[i]);
    const double along_x = (left ? cell_x[1] : cell_x[0]) + steps - (left ? x[1] : x[0]);
    const double along_y = (down ? cell_y[1] : cell_y[0]) + steps - (down ? y[1] : y[0]);
    const double t = (by_column ? along_x : along_y) * (1 / (by_column ? dx : dy));
    const bool nothing = rays.face[i] == RayChunk::kNothing || !(t < limit);
    const bool certain = rays.face[i] != RayChunk::kUndecided && dx >= kParallel && dy >= kParallel;
    rays.range[i] = certain ? (nothing ? limit : t) : RayChunk::kUncertain;
  }
}

/// Four vectors are in flight at a time, to hide memory latency.
void cast_rays(const ScanOrigin& origin, int count, RayChunk& rays) {
  static_assert(RayChunk::kSize % hn::MaxLanes(Ints()) == 0, "chunks of complete vectors");
  Queue queue(origin, count, rays);
  prepare(origin, queue.end(), rays);
  RayLanes a, b, c, d;
  queue.start(a);
  queue.start(b);
  queue.start(c);
  queue.start(d);
  while (!queue.empty()) {
    queue.step(a);
    queue.step(b);
    queue.step(c);
    queue.step(d);
  }
  measure(origin, count, rays);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slalom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace slalom {

HWY_EXPORT(cast_rays);

void cast_rays(const ScanOrigin& origin, int count, RayChunk& rays) {
  HWY_DYNAMIC_DISPATCH(cast_rays)(origin, count, rays);
}

}  // namespace slalom
#endif
