// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace slalom::math {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::uint64_t bits_of(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

double from_bits(std::uint64_t bits) {
  double x = 0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// 2^exponent, -1074 <= exponent <= 1023.
double power_of_two(int exponent) {
  return from_bits(exponent >= -1022 ? static_cast<std::uint64_t>(exponent + 1023) << 52
                                     : std::uint64_t{1} << (exponent + 1074));
}

constexpr double kToInteger = 0x1.8p52;  // its sum with |x| < 2^51 is rounded to an integer

double nearest(double x) {
  return x + kToInteger - kToInteger;
}

// Accurate phase: numbers of 256 bits -----------------------------------------------------------

__extension__ using Uint128 = unsigned __int128;

/// +-0.words 2^exponent, leading word first; its leading bit is set, or the number is zero.
struct Wide {
  bool negative = false;
  int exponent = 0;
  std::array<std::uint64_t, 4> words{};
};
struct Split {
  double head, tail;
};
struct Logarithm {
  double inverse, head, tail;
};

#include "math_tables.h"

bool is_zero(const Wide& x) {
  return x.words[0] == 0;
}

/// Number of 0.words 2^exponent, cut to 256 bits.
template <std::size_t N>
Wide normalized(bool negative, int exponent, const std::array<std::uint64_t, N>& words) {
  std::size_t first = 0;
  while (first < N && words[first] == 0) ++first;
  if (first == N) return {};
  const int shift = __builtin_clzll(words[first]);
  const auto word = [&](std::size_t i) { return i < N ? words[i] : 0; };
  Wide result{negative, exponent - 64 * static_cast<int>(first) - shift, {}};
  for (std::size_t i = 0; i < 4; ++i)
    result.words[i] = shift == 0 ? word(first + i)
                                 : word(first + i) << shift | word(first + i + 1) >> (64 - shift);
  return result;
}

Wide wide(double x) {
  const std::uint64_t bits = bits_of(x);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::array<std::uint64_t, 1> word = {fraction | std::uint64_t{field != 0} << 52};
  return normalized(bits >> 63 != 0, std::max(field, 1) - 1075 + 64, word);
}

Wide scaled(Wide x, int exponent) {
  x.exponent += exponent;
  return x;
}

Wide operator-(Wide x) {
  x.negative = !x.negative;
  return x;
}

Wide operator*(const Wide& a, const Wide& b) {
  std::array<std::uint64_t, 8> product{};
  for (std::size_t i = 4; i-- > 0;) {
    std::uint64_t carry = 0;
    for (std::size_t j = 4; j-- > 0;) {
      const Uint128 sum =
          static_cast<Uint128>(a.words[i]) * b.words[j] + product[i + j + 1] + carry;
      product[i + j + 1] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64);
    }
    product[i] = carry;
  }
  return normalized(a.negative != b.negative, a.exponent + b.exponent, product);
}

Wide operator+(const Wide& a, const Wide& b) {
  if (is_zero(b)) return a;
  if (is_zero(a) || a.exponent < b.exponent || (a.exponent == b.exponent && a.words < b.words))
    return b + a;
  const int shift = a.exponent - b.exponent;
  if (shift >= 320) return a;
  using Words = std::array<std::uint64_t, 6>;  // one for the carry, four, one more of b
  Words sum{}, other{};
  for (std::size_t i = 0; i < 4; ++i) sum[i + 1] = a.words[i];
  const auto whole = static_cast<std::size_t>(shift / 64);
  for (std::size_t i = 0; i < 4; ++i) {
    if (i + whole + 1 < 6) other[i + whole + 1] |= b.words[i] >> shift % 64;
    if (i + whole + 2 < 6 && shift % 64 != 0)
      other[i + whole + 2] |= b.words[i] << (64 - shift % 64);
  }
  const bool subtract = a.negative != b.negative;
  std::uint64_t carry = 0;
  for (std::size_t i = 6; i-- > 0;) {
    const Uint128 value = subtract ? static_cast<Uint128>(sum[i]) - other[i] - carry
                                   : static_cast<Uint128>(sum[i]) + other[i] + carry;
    sum[i] = static_cast<std::uint64_t>(value);
    carry = static_cast<std::uint64_t>(value >> 64) & 1;
  }
  return normalized(a.negative, a.exponent + 64, sum);
}

Wide operator-(const Wide& a, const Wide& b) {
  return a + -b;
}

/// Number nearest to x, rounded to 200 bits before.
double rounded(const Wide& x, bool ties_to_zero = false) {
  std::array<std::uint64_t, 5> words{};
  std::copy(x.words.begin(), x.words.end(), words.begin() + 1);
  std::uint64_t carry = std::uint64_t{1} << 55;
  for (std::size_t i = 5; i-- > 0;) {
    words[i] += carry;
    carry = words[i] < carry ? 1 : 0;
  }
  words[4] &= ~std::uint64_t{0} << 56;
  const Wide y = normalized(x.negative, x.exponent + 64, words);
  const double sign = x.negative ? -1 : 1;
  const int bits = std::min(53, y.exponent + 1074);
  if (is_zero(y) || bits < 0) return sign * 0.0;
  if (y.exponent > 1024) return sign * kInfinity;
  std::uint64_t kept = bits == 0 ? 0 : y.words[0] >> (64 - bits);
  const std::uint64_t rest = y.words[0] << bits, half = std::uint64_t{1} << 63;
  const bool tie = rest == half && (y.words[1] | y.words[2] | y.words[3]) == 0;
  if (tie ? !ties_to_zero && kept % 2 != 0 : rest >= half) ++kept;
  return sign * static_cast<double>(kept) * power_of_two(y.exponent - bits);
}

/// Newton's iteration from a double doubles the bits: 53, 105, 210, 256.
Wide quotient(const Wide& a, const Wide& b) {
  const Wide divisor = scaled(b, -b.exponent), one = wide(1);
  Wide inverse = wide(1 / rounded(divisor));
  for (int i = 0; i < 3; ++i) inverse = inverse + inverse * (one - divisor * inverse);
  return scaled(a * inverse, -b.exponent);
}

Wide root(const Wide& x) {
  if (is_zero(x)) return x;
  const int half = x.exponent >= 0 ? (x.exponent + 1) / 2 : x.exponent / 2;
  const Wide square = scaled(x, -2 * half), one = wide(1);  // from 1/4 to 1
  Wide inverse = wide(1 / std::sqrt(rounded(square)));
  for (int i = 0; i < 3; ++i)
    inverse = inverse + scaled(inverse * (one - square * inverse * inverse), -1);
  return scaled(square * inverse, half);
}

Wide wide_exp(const Wide& x) {
  constexpr int kHalvings = 8;
  const double k = nearest(rounded(x) * kInverseLn2[0]);
  const Wide r = scaled(x - wide(k) * kWideLn2, -kHalvings);
  Wide sum{};
  for (std::size_t n = 24; n-- > 0;) sum = sum * r + kInverseFactorials[n];
  for (int i = 0; i < kHalvings; ++i) sum = sum * sum;
  return scaled(sum, static_cast<int>(k));
}

/// log(x), whose value is near the guess to 2^-50: Newton's method.
Wide wide_log(const Wide& x, const Split& guess) {
  const Wide near = wide(guess.head) + wide(guess.tail);
  const Wide e = x * wide_exp(-near) - wide(1), e2 = e * e;
  return near + e - scaled(e2, -1) + e2 * e * quotient(wide(1), wide(3)) - scaled(e2 * e2, -2);
}

struct WideSinCos {
  Wide sin, cos;
};

/// |r| <= pi / 4.
WideSinCos wide_sin_cos(const Wide& r) {
  const Wide square = -(r * r);
  Wide s{}, c{};
  for (std::size_t n = 58; n > 0; n -= 2) {
    s = s * square + kInverseFactorials[n - 1];
    c = c * square + kInverseFactorials[n - 2];
  }
  return {s * r, c};
}

struct WideAngle {
  unsigned quadrant;
  Wide rest;
};

/// x = quadrant pi / 2 + rest, up to multiples of 2 pi, |rest| <= pi / 4. The mantissa is
/// multiplied by those seven words of 2 / pi that matter (Payne and Hanek 1983).
WideAngle wide_reduced(double x) {
  const Wide w = wide(x);
  if (std::abs(x) < 0.78) return {0, w};
  const int exponent = w.exponent - 53;  // of the mantissa as an integer
  const std::uint64_t mantissa = w.words[0] >> 11;
  const auto first = static_cast<std::size_t>(std::max(exponent - 2, 0) / 64);
  std::array<std::uint64_t, 9> product{};  // the last remains zero
  std::uint64_t carry = 0;
  for (std::size_t i = 7; i-- > 0;) {
    const Uint128 sum = static_cast<Uint128>(mantissa) * kTwoOverPi[first + i] + carry;
    product[i + 1] = static_cast<std::uint64_t>(sum);
    carry = static_cast<std::uint64_t>(sum >> 64);
  }
  product[0] = carry;
  // 0.product 2^integer = |x| 2 / pi, up to multiples of 4
  const int integer = 64 + exponent - 64 * static_cast<int>(first);
  const auto from = static_cast<std::size_t>((integer - 2) / 64);
  const int shift = (integer - 2) % 64;
  std::array<std::uint64_t, 7> turned{};
  const auto word = [&](std::size_t i) { return i < 9 ? product[i] : 0; };
  for (std::size_t i = 0; i < 7; ++i)
    turned[i] =
        shift == 0 ? word(from + i) : word(from + i) << shift | word(from + i + 1) >> (64 - shift);
  auto quadrant = static_cast<unsigned>(turned[0] >> 62);
  turned[0] &= ~std::uint64_t{0} >> 2;
  Wide turns = normalized(false, 2, turned);
  if (turns.exponent == 0) {  // from 1/2 to 1
    turns = turns - wide(1);
    ++quadrant;
  }
  if (x < 0) {
    quadrant = 0 - quadrant;
    turns = -turns;
  }
  return {quadrant % 4, turns * kWideHalfPi};
}

double accurate_sine(double x, unsigned quadrants) {
  const WideAngle angle = wide_reduced(x);
  const WideSinCos both = wide_sin_cos(angle.rest);
  const unsigned q = angle.quadrant + quadrants;
  const Wide& value = q % 2 != 0 ? both.cos : both.sin;
  return rounded((q & 2) != 0 ? -value : value);
}

// Fast phase: pairs of doubles ------------------------------------------------------------------

/// x rounded to 26 bits; the rest has 26 bits too, so that products of heads and rests are exact.
double head(double x) {
  return from_bits((bits_of(x) + (std::uint64_t{1} << 26)) & ~std::uint64_t{0} << 27);
}

/// Sum of a and b as a pair, |a| >= |b| or a = 0 (Dekker 1971).
Split fast_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// Sum of any a and b as a pair (Knuth 1969).
Split exact_sum(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// Product as a pair (Dekker 1971).
Split product(double a, double b) {
  const double p = a * b, ah = head(a), bh = head(b), al = a - ah, bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

Split product(const Split& a, const Split& b) {
  const Split p = product(a.head, b.head);
  return fast_sum(p.head, p.tail + (a.head * b.tail + a.tail * b.head));
}

/// Whether all numbers within the error of the sum of the pair round alike, to result (Ziv 1991).
bool decided(const Split& x, double error, double& result) {
  result = x.head + (x.tail + error);
  return result == x.head + (x.tail - error);
}

/// An angle k pi / 256 + rest, |rest| <= pi / 512; |error of rest| <= error.
struct Reduced {
  unsigned k = 0;
  Split rest{};
  double error = 0;
};

/// x + tail, |x| < 12800, so that the products of k < 2^20 and 33 bits are exact (Cody and Waite
/// 1980).
Reduced steps_of(double x, double tail) {
  const double shifted = x * (1 / (kPiOver256[0] + kPiOver256[1])) + kToInteger;
  const double k = shifted - kToInteger;
  Split rest = exact_sum(x - k * kPiOver256[0], -(k * kPiOver256[1]));
  rest = exact_sum(rest.head, rest.tail + (tail - k * kPiOver256[2]));
  return {static_cast<unsigned>(bits_of(shifted)), rest, std::abs(k) * 0x1p-124};
}

Reduced reduced(double x) {
  if (std::abs(x) < 0x1p-8) return {0, {x, 0}, 0};
  if (std::abs(x) < 12800) return steps_of(x, 0);
  const WideAngle angle = wide_reduced(x);
  const double near = rounded(angle.rest);
  Reduced result = steps_of(near, rounded(angle.rest - wide(near)));
  result.k += angle.quadrant * 128;
  return result;
}

/// Functions of the rest r of an angle, which are the same for its sine and cosine.
struct RestFunctions {
  double top;     ///< r in 26 bits
  double sine;    ///< sin(r) - r
  double cosine;  ///< cos(r) - 1
  double rest;    ///< sin(r) - top
};

RestFunctions functions_of(const Split& r) {
  const double r2 = r.head * r.head, top = r.head + 0x1.8p19 - 0x1.8p19;
  const double sine = r.head * r2 * (-1.0 / 6 + r2 * (1.0 / 120 + r2 * (-1.0 / 5040)));
  const double cosine = r2 * (-0.5 + r2 * (1.0 / 24 + r2 * (-1.0 / 720 + r2 * (1.0 / 40320))));
  return {top, sine, cosine, ((r.head - top) + r.tail) + sine};
}

/// sin(a + r) = S cos(r) + C sin(r), where S and C are those of the table at a. The errors are
/// those of r^2 / 2, below 5 roundings of 2^-15.7 S, where the sum is at least S / 2: 2^-65.4.
bool fast_sine(const Reduced& angle, const RestFunctions& of, unsigned steps, double& result) {
  const unsigned k = angle.k + steps, i = k & 127U;
  const bool odd = (k & 128U) != 0;
  const Split s = kSines[odd ? 128 - i : i], cosine = kSines[odd ? i : 128 - i];
  const double sign = odd ? -1 : 1;
  const Split c = {sign * cosine.head, sign * cosine.tail};
  Split sum{};
  if (s.head == 0) {
    sum = {sign * angle.rest.head, sign * (angle.rest.tail + of.sine)};
  } else {
    sum = fast_sum(s.head, c.head * of.top);  // an exact product
    sum.tail +=
        s.tail + ((s.head + s.tail) * of.cosine + (c.tail * of.top + (c.head + c.tail) * of.rest));
  }
  const bool known = decided(sum, std::abs(sum.head) * 0x1p-65 + angle.error, result);
  if ((k & 256U) != 0) result = -result;
  return known;
}

double sine(double x, const Reduced& angle, const RestFunctions& of, unsigned quadrants) {
  double result = 0;
  return fast_sine(angle, of, quadrants * 128, result) ? result : accurate_sine(x, quadrants);
}

double sine(double x, unsigned quadrants) {
  const Reduced angle = reduced(x);
  return sine(x, angle, functions_of(angle.rest), quadrants);
}

/// exp(x) = 2^exponent (head + tail), x normalized, |x| < 1100. With |r| <= ln 2 / 256 the errors
/// are those of r^2 / 2 and of the sum: below 4 roundings of 2^-17.
Split fast_exp(const Split& x, int& exponent) {
  const double shifted = x.head * (128 * kInverseLn2[0]) + kToInteger;
  const double k = shifted - kToInteger;
  Split r = exact_sum(x.head - k * kLn2Over128[0], -(k * kLn2Over128[1]));
  r = exact_sum(r.head, r.tail + (x.tail - k * kLn2Over128[2]));
  const auto bits = static_cast<std::int32_t>(bits_of(shifted));
  const int i = bits & 127;
  exponent = (bits - i) / 128;
  const double p = r.head, p2 = p * p;
  const double higher =
      p2 * ((0.5 + p * (1.0 / 6)) + p2 * ((1.0 / 24 + p * (1.0 / 120)) + p2 * (1.0 / 720)));
  const double top =
      p + 0x1.8p18 - 0x1.8p18;  // of 26 bits, so that its product with 27 bits is exact
  const Split& power = kPowers[i];
  Split sum = fast_sum(power.head, power.head * top);
  sum.tail +=
      power.tail + (power.tail * top + (power.head + power.tail) * (((p - top) + r.tail) + higher));
  return sum;
}

/// exp(x) or the accurate phase's value.
template <typename Accurate>
double rounded_exp(const Split& x, double error, Accurate accurate) {
  if (x.head > 710) return kInfinity;
  if (x.head < -746) return 0;
  int exponent = 0;
  double result = 0;
  const Split sum = fast_exp(x, exponent);
  if (exponent > -1022 && exponent < 1023 && decided(sum, error, result))
    return result * power_of_two(exponent);
  return rounded(accurate());
}

/// log(x) = exponent log 2 + log(m), x > 0 finite; with log2 set divided by log 2. With |r| <=
/// 1/256 the errors are below 6 roundings of r^3 / 3, which is 2^-25.6 and at most 2^-17.6 of the
/// sum: 2^-67; if precise, those of r^4 / 4: 2^-76.
template <bool precise>
Split fast_log(double x, double* log2 = nullptr) {
  int exponent = 0;
  if (x < 0x1p-1022) {
    x *= 0x1p54;
    exponent = -54;
  }
  const std::uint64_t bits = bits_of(x), fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const auto i = static_cast<unsigned>(fraction >> 44);
  exponent += static_cast<int>(bits >> 52) - 1023 + (i >= 106 ? 1 : 0);
  const Logarithm& entry = kLogarithms[i];
  const double m = from_bits(fraction | bits_of(1)), mh = head(m);
  const double r =
      (mh * entry.inverse - 1) + (m - mh) * entry.inverse;  // exact: a multiple of 2^-61
  const double k = log2 != nullptr ? 0 : exponent;
  const double top = r + 0x1.8p18 - 0x1.8p18, r2 = r * r;
  Split sum = fast_sum(k * kLn2[0] + entry.head, r);
  const Split next = fast_sum(sum.head, -0.5 * (top * top));
  double tail = entry.tail + k * kLn2[1] - 0.5 * ((r - top) * (r + top));
  const double fourth =
      -0.25 + r * 0.2 +
      r2 * ((-1.0 / 6 + r * (1.0 / 7)) + r2 * (-0.125 + r * (1.0 / 9) - r2 * 0.1));
  if constexpr (precise) {
    const double square_tail = (top * top - r2) + (r - top) * (r + top);
    const Split cube = product(product(r2, r), {kThird[0], kThird[1]});
    const Split third = fast_sum(next.head, cube.head);
    tail += third.tail + (cube.tail + (square_tail * r * kThird[0] + r2 * r2 * fourth));
    sum = {third.head, tail + (sum.tail + next.tail)};
  } else {
    sum = {next.head, tail + (sum.tail + next.tail) + r * r2 * (1.0 / 3 + r * fourth)};
  }
  if (log2 != nullptr) *log2 = exponent;
  return fast_sum(sum.head, sum.tail);
}

Wide accurate_log(double x) {
  return wide_log(wide(x), fast_log<true>(x));
}

/// Values of log() and log2() at x that is not positive and finite.
double log_outside(double x) {
  if (x == 0) return -kInfinity;
  return x > 0 || x != x ? x : kNan;
}

enum class Parity { None, Even, Odd };

Parity parity(double y) {
  y = std::abs(y);
  if (y >= 0x1p53) return Parity::Even;
  const auto whole = static_cast<std::int64_t>(y);
  if (static_cast<double>(whole) != y) return Parity::None;
  return whole % 2 != 0 ? Parity::Odd : Parity::Even;
}

/// x^y with x or y zero, infinite or NaN, but neither x = 1 nor y = 0.
double pow_outside(double x, double y) {
  if (x != x || y != y) return x + y;
  const double size = std::abs(x);
  if (std::abs(y) == kInfinity) {
    if (size == 1) return 1;
    return (size > 1) == (y > 0) ? kInfinity : 0;
  }
  const double result = (size > 1) == (y > 0) ? kInfinity : 0;
  return parity(y) == Parity::Odd && bits_of(x) >> 63 != 0 ? -result : result;
}

/// atan(n / d) from the step below it, a multiple of 1/128: head of kArcs + (head + tail), 0 <= n
/// <= d, both from 2^-400 to 2^400. The difference of arcs is that of tangent t = (n - c d) / (d +
/// c n), |t| < 1/250. The error is that of the denominator, 2^-61 t, and of t^3 / 3: below 2^-67 of
/// the sum.
struct Arc {
  double step;
  Split rest;
};

Arc fast_atan(const Split& n, const Split& d) {
  const auto i =
      static_cast<int>(n.head / d.head * 128 + 0.49);  // 0.49: n - c d has an exact head (Sterbenz)
  const double c = i * 0x1p-7, square = 1 + c * c;
  const double dh = head(d.head), dl = d.head - dh;
  Split numerator = exact_sum(n.head - c * dh, -(c * dl));
  numerator.tail += n.tail - c * d.tail;
  const Split denominator = fast_sum(dh * square, dl * square + c * numerator.head);  // d + c n
  const double inverse = 1 / denominator.head, t = numerator.head / denominator.head;
  const Split back = product(t, denominator.head);
  const double remainder = ((numerator.head - back.head) - back.tail) + numerator.tail -
                           t * (denominator.tail + (square * d.tail + c * numerator.tail));
  const double t2 = t * t;
  const double higher = t * t2 * (-1.0 / 3 + t2 * (0.2 + t2 * (-1.0 / 7 + t2 * (1.0 / 9))));
  return {kArcs[i].head, {t, kArcs[i].tail + (remainder * inverse + higher)}};
}

/// atan(n / d), 0 <= n <= d: Newton's method on the tangent.
Wide wide_atan(const Wide& n, const Wide& d) {
  const Wide tangent = quotient(n, d), third = quotient(wide(1), wide(3));
  if (tangent.exponent < -110) return tangent - tangent * tangent * tangent * third;
  const Arc arc = fast_atan({rounded(tangent), 0}, {1, 0});
  const Wide guess = wide(arc.step + arc.rest.head);
  const WideSinCos both = wide_sin_cos(guess);
  const Wide t = quotient(n * both.cos - d * both.sin, d * both.cos + n * both.sin), t2 = t * t;
  return guess + t - t * t2 * third + t2 * t2 * t * quotient(wide(1), wide(5));
}

/// Direction of the vector (x, y) of wide numbers.
double accurate_direction(Wide y, Wide x) {
  const bool below = y.negative, left = x.negative;
  y.negative = x.negative = false;
  const bool steep = (x - y).negative;
  Wide angle = steep ? kWideHalfPi - wide_atan(x, y) : wide_atan(y, x);
  if (left) angle = kWidePi - angle;
  // An arc below half of the least number's multiples is less than its tangent, which may be such a
  // half.
  return rounded(below ? -angle : angle, true);
}

/// Either number without a branch, which takes longer than all else when it goes at random.
double select(bool first, double a, double b) {
  const std::uint64_t mask = std::uint64_t{0} - std::uint64_t{first};
  return from_bits((bits_of(a) & mask) | (bits_of(b) & ~mask));
}

/// Direction of the vector (x, y) of pairs from 2^-400 to 2^400 without signs.
bool fast_direction(const Split& y, const Split& x, bool left, double& result) {
  const bool steep = y.head > x.head;
  const Arc arc = fast_atan({std::min(x.head, y.head), select(steep, x.tail, y.tail)},
                            {std::max(x.head, y.head), select(steep, y.tail, x.tail)});
  const double sign = select(steep != left, -1, 1);
  const double right_angles = select(steep, 1, select(left, 2, 0));
  const Split sum = fast_sum(right_angles * kHalfPi[0] + sign * arc.step,
                             sign * arc.rest.head);  // first sum exact
  const double tail = sum.tail + (right_angles * kHalfPi[1] + sign * arc.rest.tail);
  return decided({sum.head, tail}, sum.head * 0x1p-66, result);
}

/// sqrt(1 - x^2), 0 <= x < 1.
Split other_leg(double x) {
  const Split square = product(x, x);
  Split rest = fast_sum(1, -square.head);
  rest = fast_sum(rest.head, rest.tail - square.tail);
  const double root = std::sqrt(rest.head);
  const Split back = product(root, root);
  return {root, (((rest.head - back.head) - back.tail) + rest.tail) / (2 * root)};
}

Wide wide_other_leg(double x) {
  const Wide w = wide(x);
  return root(wide(1) - w * w);
}

/// atan2() with a zero, infinite or NaN argument.
double atan2_outside(double y, double x) {
  if (x != x || y != y) return x + y;
  const bool left = bits_of(x) >> 63 != 0;
  const double size = std::abs(y), sign = bits_of(y) >> 63 != 0 ? -1 : 1;
  constexpr double kPi = 2 * kHalfPi[0];
  if (size == kInfinity && std::abs(x) == kInfinity)
    return sign * (left ? kThreeQuartersPi : kPi / 4);
  if (y == 0 || std::abs(x) == kInfinity) return sign * (left ? kPi : 0);
  return sign * kHalfPi[0];
}

}  // namespace

double sin(double x) {
  if (std::abs(x) < 0x1p-26) return x;  // nearest, since |sin x - x| < 2^-54 |x|
  if (!(std::abs(x) < kInfinity)) return kNan;
  return sine(x, 0);
}

double cos(double x) {
  if (!(std::abs(x) < kInfinity)) return kNan;
  return sine(x, 1);
}

SinCos sin_cos(double x) {
  if (!(std::abs(x) < kInfinity)) return {kNan, kNan};
  const Reduced angle = reduced(x);
  const RestFunctions of = functions_of(angle.rest);
  return {std::abs(x) < 0x1p-26 ? x : sine(x, angle, of, 0), sine(x, angle, of, 1)};
}

double atan2(double y, double x) {
  const double height = std::abs(y), width = std::abs(x);
  if (!(height > 0 && height < kInfinity && width > 0 && width < kInfinity))
    return atan2_outside(y, x);
  double result = 0;
  if (std::min(height, width) > 0x1p-400 && std::max(height, width) < 0x1p400 &&
      fast_direction({height, 0}, {width, 0}, x < 0, result))
    return std::copysign(result, y);
  return accurate_direction(wide(y), wide(x));
}

double asin(double x) {
  const double size = std::abs(x);
  if (size < 0x1p-26) return x;  // nearest, since |asin x - x| < 2^-54 |x|
  if (size == 1) return x * kHalfPi[0];
  if (!(size < 1)) return x + kNan;
  double result = 0;
  if (fast_direction({size, 0}, other_leg(size), false, result)) return std::copysign(result, x);
  return accurate_direction(wide(x), wide_other_leg(x));
}

double acos(double x) {
  const double size = std::abs(x);
  if (size < 0x1p-60)
    return kHalfPi[0];  // nearest, since the rest of pi / 2 is 0.55 of half a unit
  if (size == 1) return x < 0 ? 2 * kHalfPi[0] : 0;
  if (!(size < 1)) return x + kNan;
  double result = 0;
  if (fast_direction(other_leg(size), {size, 0}, x < 0, result)) return result;
  return accurate_direction(wide_other_leg(x), wide(x));
}

double exp(double x) {
  if (x != x) return x;
  return rounded_exp({x, 0}, 0x1p-66, [&] { return wide_exp(wide(x)); });
}

double log(double x) {
  if (!(x > 0 && x < kInfinity)) return log_outside(x);
  const Split sum = fast_log<false>(x);
  double result = 0;
  return decided(sum, std::abs(sum.head) * 0x1p-67, result) ? result : rounded(accurate_log(x));
}

double log2(double x) {
  if (!(x > 0 && x < kInfinity)) return log_outside(x);
  double exponent = 0, result = 0;
  const Split part = product(fast_log<false>(x, &exponent), {kInverseLn2[0], kInverseLn2[1]});
  Split sum = fast_sum(exponent, part.head);
  sum.tail += part.tail;
  if (decided(sum, std::abs(sum.head) * 0x1p-66, result)) return result;
  return rounded(accurate_log(x) * kWideInverseLn2);
}

double pow(double x, double y) {
  if (x == 1 || y == 0) return 1;
  const double size = std::abs(x);
  if (!(size > 0 && size < kInfinity && std::abs(y) < kInfinity)) return pow_outside(x, y);
  const Parity whole = parity(y);
  if (x < 0 && whole == Parity::None) return kNan;
  const double sign = x < 0 && whole == Parity::Odd ? -1 : 1;
  if (size == 1) return sign;
  const Split log = fast_log<true>(size);
  const double estimate = y * log.head;
  if (std::abs(estimate) > 800) return sign * (estimate > 0 ? kInfinity : 0);
  Split exponent = product(y, log.head);
  exponent = fast_sum(exponent.head, exponent.tail + y * log.tail);
  const double error = 0x1p-66 + std::abs(exponent.head) * 0x1p-75;
  return sign *
         rounded_exp(exponent, error, [&] { return wide_exp(wide(y) * accurate_log(size)); });
}

double hypot(double x, double y) {
  x = std::abs(x);
  y = std::abs(y);
  if (!(x < kInfinity && y < kInfinity))
    return x == kInfinity || y == kInfinity ? kInfinity : x + y;
  double a = std::max(x, y), b = std::min(x, y), scale = 1;
  if (b <= a * 0x1p-54) return a + b;
  if (a > 0x1p511) scale = 0x1p600;
  if (b < 0x1p-459) scale = 0x1p-600;
  if (scale != 1) {
    a /= scale;
    b /= scale;
  }
  const double h = std::sqrt(a * a + b * b);
  // h^2 - a^2 - b^2 from differences that are exact (Sterbenz)
  double main = 0, rest = 0;
  if (h <= 2 * b) {
    const double d = h - b;
    main = a * (2 * d - a);
    rest = (d - 2 * (a - b)) * d;
  } else {
    const double d = h - a;
    main = 2 * d * (a - 2 * b);
    rest = (4 * d - b) * b + d * d;
  }
  return (h - (main + rest) / (2 * h)) * scale;
}

}  // namespace slalom::math
