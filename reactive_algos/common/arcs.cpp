// SPDX-License-Identifier: BSD-3-Clause
#include "common/arcs.h"

#include <slalom/core/math.h>

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/arcs.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which sets the instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace reactive {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Reals = hn::CappedTag<double, kMaxLanes / 2>;
using Real = hn::Vec<Reals>;

/// The polynomial of x with these coefficients, from the highest, by Horner's rule.
template <std::size_t N>
HWY_INLINE Real polynomial(const double (&coefficients)[N], Real x) {
  const Reals d;
  auto sum = hn::Set(d, coefficients[0]);
  for (std::size_t i = 1; i < N; ++i) sum = hn::Add(hn::Mul(sum, x), hn::Set(d, coefficients[i]));
  return sum;
}

/// Taylor's series of sin(x) / x and cos(x) as polynomials of x^2. For |x| <= pi / 4 the rest is
/// below 1e-17.
HWY_INLINE Real sinc_near_zero(Real square) {
  static constexpr double kInverseFactorials[] = {1 / 355687428096000.0,
                                                  -1 / 1307674368000.0,
                                                  1 / 6227020800.0,
                                                  -1 / 39916800.0,
                                                  1 / 362880.0,
                                                  -1 / 5040.0,
                                                  1 / 120.0,
                                                  -1 / 6.0,
                                                  1.0};
  return polynomial(kInverseFactorials, square);
}
HWY_INLINE Real cosine_near_zero(Real square) {
  static constexpr double kInverseFactorials[] = {1 / 20922789888000.0,
                                                  -1 / 87178291200.0,
                                                  1 / 479001600.0,
                                                  -1 / 3628800.0,
                                                  1 / 40320.0,
                                                  -1 / 720.0,
                                                  1 / 24.0,
                                                  -1 / 2.0,
                                                  1.0};
  return polynomial(kInverseFactorials, square);
}

struct SineCosine {
  Real sine, cosine;
};

/// The angle minus the nearest multiple of pi / 2 is in [-pi / 4, pi / 4]; the multiple selects
/// among +-sine and +-cosine. pi / 2 is the sum of a number with 33 bits, whose multiples are
/// exact, and the rest.
HWY_INLINE SineCosine sine_and_cosine(Real angle) {
  const Reals d;
  constexpr double kHighPart = 0x1.921fb544p+0, kLowPart = 0x1.0b4611a626331p-34;
  const auto turns = hn::Round(hn::Mul(angle, hn::Set(d, M_2_PI)));
  const auto rest = hn::Sub(hn::Sub(angle, hn::Mul(turns, hn::Set(d, kHighPart))),
                            hn::Mul(turns, hn::Set(d, kLowPart)));
  const auto square = hn::Mul(rest, rest);
  const auto sine = hn::Mul(rest, sinc_near_zero(square)), cosine = cosine_near_zero(square);
  const auto quarter = hn::Set(d, 0.25), four = hn::Set(d, 4.0);
  const auto quadrant = hn::Sub(turns, hn::Mul(four, hn::Floor(hn::Mul(turns, quarter))));
  const auto one = hn::Set(d, 1.0), two = hn::Set(d, 2.0), three = hn::Set(d, 3.0);
  const auto swapped = hn::Or(hn::Eq(quadrant, one), hn::Eq(quadrant, three));
  const auto sine_negative = hn::Ge(quadrant, two);
  const auto cosine_negative = hn::Or(hn::Eq(quadrant, one), hn::Eq(quadrant, two));
  const auto s = hn::IfThenElse(swapped, cosine, sine), c = hn::IfThenElse(swapped, sine, cosine);
  return {hn::IfThenElse(sine_negative, hn::Neg(s), s),
          hn::IfThenElse(cosine_negative, hn::Neg(c), c)};
}

/// The heading is turned by half the angle, the pose moved along the chord, the heading turned by
/// the other half.
void move_along_arcs(const double* lengths, const double* turns, std::size_t count,
                     PoseBatch& poses) {
  const Reals d;
  const auto half = hn::Set(d, 0.5), small = hn::Set(d, 1e-6), one = hn::Set(d, 1.0);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto angle = hn::Mul(half, hn::LoadU(d, turns + i));
    const auto [sine, cosine] = sine_and_cosine(angle);
    const auto straight = hn::Lt(hn::Abs(angle), small);
    const auto sinc = hn::IfThenElse(straight, one, hn::Div(sine, angle));
    const auto chord = hn::Mul(hn::LoadU(d, lengths + i), sinc);
    auto c = hn::LoadU(d, &poses.cosine[i]), s = hn::LoadU(d, &poses.sine[i]);
    const auto turn = [&, &sin = sine, &cos = cosine] {
      const auto turned = hn::Sub(hn::Mul(c, cos), hn::Mul(s, sin));
      s = hn::Add(hn::Mul(s, cos), hn::Mul(c, sin));
      c = turned;
    };
    turn();
    hn::StoreU(hn::Add(hn::LoadU(d, &poses.x[i]), hn::Mul(chord, c)), d, &poses.x[i]);
    hn::StoreU(hn::Add(hn::LoadU(d, &poses.y[i]), hn::Mul(chord, s)), d, &poses.y[i]);
    turn();
    hn::StoreU(c, d, &poses.cosine[i]);
    hn::StoreU(s, d, &poses.sine[i]);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace reactive
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reactive {

HWY_EXPORT(move_along_arcs);

void move_along_arcs(const double* lengths, const double* turns, std::size_t count,
                     PoseBatch& poses) {
  HWY_DYNAMIC_DISPATCH(move_along_arcs)(lengths, turns, count, poses);
}

void PoseBatch::assign(std::size_t size, const Pose& pose) {
  x.assign(padded(size), pose.x);
  y.assign(padded(size), pose.y);
  cosine.assign(padded(size), slalom::math::cos(pose.phi));
  sine.assign(padded(size), slalom::math::sin(pose.phi));
}

}  // namespace reactive
#endif
