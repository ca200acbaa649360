// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#ifdef SLALOM_HAS_MPFR
#include <mpfr.h>
#endif

namespace slalom::math {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kMin = 0x1p-1074;
constexpr double kMax = std::numeric_limits<double>::max();

std::uint64_t bits(double x) {
  std::uint64_t result = 0;
  std::memcpy(&result, &x, sizeof x);
  return x != x ? ~std::uint64_t{0} : result;
}

double of_bits(std::uint64_t bits) {
  double result = 0;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

using OfOne = double (*)(double);
using OfTwo = double (*)(double, double);

struct Case {
  OfOne one;
  OfTwo two;
  double x, y, result;
};
Case of(OfOne f, double x, double result) {
  return {f, nullptr, x, 0, result};
}
Case of(OfTwo f, double x, double y, double result) {
  return {nullptr, f, x, y, result};
}

void expect_bits(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    const double result = c.one != nullptr ? c.one(c.x) : c.two(c.x, c.y);
    EXPECT_EQ(bits(result), bits(c.result))
        << &c - cases.data() << ": " << std::hexfloat << c.x << " " << c.y << ": " << result;
  }
}

std::uint64_t mix(std::uint64_t x) {
  x = (x ^ x >> 33) * 0xff51afd7ed558ccdULL;
  x = (x ^ x >> 33) * 0xc4ceb9fe1a85ec53ULL;
  return x ^ x >> 33;
}

constexpr int kKinds = 8;

/// Number i of a kind: angles, tens, many scales, near multiples of pi / 2, any bits, near powers
/// of two, small or special, near one.
double argument(int kind, std::uint64_t i, std::uint64_t stream = 0) {
  const std::uint64_t h = mix(i * 2 + stream + 1), g = mix(h);
  const double unit = static_cast<double>(h >> 11) * 0x1p-52 - 1;
  switch (kind) {
    case 0:
      return unit * 3.141592653589793;
    case 1:
      return unit * 100;
    case 2:
      return of_bits((h & 0x800fffffffffffffULL) | (1023 - 40 + g % 81) << 52);
    case 3:
      return of_bits(bits((static_cast<double>(h % 2001) - 1000) * 1.5707963267948966) + g % 9);
    case 4:
      return of_bits(h);
    case 5:
      return of_bits((h & 1) << 63 | g % 2047 << 52) *
             (1 + (static_cast<double>(g % 3) - 1) * 0x1p-52);
    case 6: {
      constexpr double kSpecial[] = {0.0,  -0.0,  1,    -1,   0.5,   -0.5,      2,    -2,    3,
                                     kInf, -kInf, kNaN, kMin, -kMin, 0x1p-1022, kMax, -kMax, 1e22};
      return h % 2 == 0 ? of_bits(g % (1ULL << 52)) : kSpecial[g % std::size(kSpecial)];
    }
    default:
      return 1 + unit * of_bits((1023 - g % 53) << 52);
  }
}

TEST(Math, SpecialValuesAreThoseOfAnnexF) {
  const double pi = 0x1.921fb54442d18p+1;
  expect_bits({
      of(sin, 0.0, 0.0),
      of(sin, -0.0, -0.0),
      of(sin, kInf, kNaN),
      of(sin, -kInf, kNaN),
      of(sin, kNaN, kNaN),
      of(cos, 0.0, 1),
      of(cos, -0.0, 1),
      of(cos, kInf, kNaN),
      of(cos, kNaN, kNaN),
      of(asin, 0.0, 0.0),
      of(asin, -0.0, -0.0),
      of(asin, 1, pi / 2),
      of(asin, -1, -pi / 2),
      of(asin, 0x1.0000000000001p0, kNaN),
      of(asin, -kInf, kNaN),
      of(asin, kNaN, kNaN),
      of(acos, 1, 0.0),
      of(acos, -1, pi),
      of(acos, 0.0, pi / 2),
      of(acos, -0.0, pi / 2),
      of(acos, 0x1.0000000000001p0, kNaN),
      of(acos, kInf, kNaN),
      of(acos, kNaN, kNaN),
      of(exp, 0.0, 1),
      of(exp, -0.0, 1),
      of(exp, kInf, kInf),
      of(exp, -kInf, 0.0),
      of(exp, kNaN, kNaN),
      of(exp, kMax, kInf),
      of(exp, -kMax, 0.0),
      of(log, 0.0, -kInf),
      of(log, -0.0, -kInf),
      of(log, 1, 0.0),
      of(log, -1, kNaN),
      of(log, kInf, kInf),
      of(log, -kInf, kNaN),
      of(log, kNaN, kNaN),
      of(log2, 0.0, -kInf),
      of(log2, 1, 0.0),
      of(log2, -1, kNaN),
      of(log2, kInf, kInf),
      of(log2, kNaN, kNaN),
      of(log2, kMin, -1074),
      of(log2, 8, 3),
      of(atan2, 0.0, 1, 0.0),
      of(atan2, -0.0, 1, -0.0),
      of(atan2, 0.0, -1, pi),
      of(atan2, -0.0, -1, -pi),
      of(atan2, 0.0, 0.0, 0.0),
      of(atan2, -0.0, 0.0, -0.0),
      of(atan2, 0.0, -0.0, pi),
      of(atan2, -0.0, -0.0, -pi),
      of(atan2, 1, 0.0, pi / 2),
      of(atan2, 1, -0.0, pi / 2),
      of(atan2, -1, 0.0, -pi / 2),
      of(atan2, 1, kInf, 0.0),
      of(atan2, -1, kInf, -0.0),
      of(atan2, 1, -kInf, pi),
      of(atan2, -1, -kInf, -pi),
      of(atan2, kInf, 1, pi / 2),
      of(atan2, -kInf, -1, -pi / 2),
      of(atan2, kInf, kInf, pi / 4),
      of(atan2, kInf, -kInf, 0x1.2d97c7f3321d2p+1),
      of(atan2, -kInf, kInf, -pi / 4),
      of(atan2, -kInf, -kInf, -0x1.2d97c7f3321d2p+1),
      of(atan2, kNaN, 1, kNaN),
      of(atan2, 0.0, kNaN, kNaN),
      of(hypot, kInf, kNaN, kInf),
      of(hypot, kNaN, -kInf, kInf),
      of(hypot, kNaN, 1, kNaN),
      of(hypot, -0.0, -0.0, 0.0),
  });
}

TEST(Math, SpecialValuesOfPowAreThoseOfAnnexF) {
  expect_bits({
      of(pow, 0.0, -3, kInf),       of(pow, -0.0, -3, -kInf),    of(pow, -0.0, -2, kInf),
      of(pow, -0.0, -2.5, kInf),    of(pow, 0.0, -kInf, kInf),   of(pow, -0.0, 3, -0.0),
      of(pow, 0.0, 3, 0.0),         of(pow, -0.0, 2.5, 0.0),     of(pow, -0.0, 0x1p53, 0.0),
      of(pow, -1, kInf, 1),         of(pow, -1, -kInf, 1),       of(pow, 1, kNaN, 1),
      of(pow, kNaN, 0.0, 1),        of(pow, kNaN, -0.0, 1),      of(pow, kInf, 0.0, 1),
      of(pow, kNaN, 1, kNaN),       of(pow, 2, kNaN, kNaN),      of(pow, -2, 0.5, kNaN),
      of(pow, -kMax, -2.5, kNaN),   of(pow, 0.5, -kInf, kInf),   of(pow, -2, -kInf, 0.0),
      of(pow, -0.5, kInf, 0.0),     of(pow, 2, kInf, kInf),      of(pow, -kInf, -3, -0.0),
      of(pow, -kInf, -2, 0.0),      of(pow, -kInf, -0.5, 0.0),   of(pow, -kInf, 3, -kInf),
      of(pow, -kInf, 2, kInf),      of(pow, kInf, -0.5, 0.0),    of(pow, kInf, 0.5, kInf),
      of(pow, -2, 3, -8),           of(pow, -2, 1025, -kInf),    of(pow, -2, -1077, -0.0),
      of(pow, -kMax, 0x1p60, kInf), of(pow, -1, 0x1p52 + 1, -1), of(pow, -1, 0x1p53, 1),
      of(pow, 0.5, kMax, 0.0),      of(pow, 0.5, -kMax, kInf),
  });
}

TEST(Math, ResultsBelowTheLeastNormalNumberAreRoundedOnce) {
  expect_bits({
      of(pow, 2, -1074, kMin),
      of(pow, 2, -1075, 0.0),
      of(pow, 4, -537.5, 0.0),
      of(pow, 0x1.8p-537, 2, 2 * kMin),
      of(pow, 0x1.8p-1073, 1, 3 * kMin),
      of(exp, -745.2, 0.0),
      of(exp, -745, kMin),
      // The arc is less than its tangent, which is here 1.5, 2.5 and 3.5 of the least number
      of(atan2, 3 * kMin, 2, kMin),
      of(atan2, 5 * kMin, 2, 2 * kMin),
      of(atan2, -7 * kMin, 2, -3 * kMin),
      of(atan2, kMin, 2, 0.0),
      of(atan2, kMin, kMax, 0.0),
      of(atan2, kMin, -kMax, 0x1.921fb54442d18p+1),
      of(sin, kMin, kMin),
      of(sin, -0x1.fffffffffffffp-1023, -0x1.fffffffffffffp-1023),
      of(asin, kMin, kMin),
  });
}

TEST(Math, PowersOfIntegersAreThoseOfIntegerArithmetic) {
  // Conversion of an integer rounds to nearest, ties to even: powers of 54 bits are midpoints
  for (std::uint64_t n = 2; n < 3000; ++n) {
    std::uint64_t power = n;
    for (int k = 1; power <= ~std::uint64_t{0} / n; ++k, power *= n)
      ASSERT_EQ(pow(static_cast<double>(n), k), static_cast<double>(power)) << n << " " << k;
  }
  for (std::uint64_t n = (1U << 27) - 2001; n < 1U << 27; n += 2)
    ASSERT_EQ(pow(static_cast<double>(n), 2), static_cast<double>(n * n)) << n;
}

TEST(Math, PowersAgreeWithCorrectlyRoundedOperations) {
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const double x = std::abs(argument(2, i));
    ASSERT_EQ(pow(x, 2), x * x) << x;
    ASSERT_EQ(pow(x, -1), 1 / x) << x;
    ASSERT_EQ(pow(x, 0.5), std::sqrt(x)) << x;
    ASSERT_EQ(pow(x, 1), x);
    ASSERT_EQ(pow(x, -2), pow(-x, -2)) << x;
  }
}

TEST(Math, FunctionsAreOddOrEven) {
  for (int kind = 0; kind < kKinds; ++kind)
    for (std::uint64_t i = 0; i < 5'000; ++i) {
      const double x = argument(kind, i), y = argument(kind, i, 1);
      ASSERT_EQ(bits(sin(-x)), bits(-sin(x))) << x;
      ASSERT_EQ(bits(cos(-x)), bits(cos(x))) << x;
      ASSERT_EQ(bits(asin(-x)), bits(-asin(x))) << x;
      ASSERT_EQ(bits(atan2(-y, x)), bits(-atan2(y, x))) << y << " " << x;
      const SinCos both = sin_cos(x);
      ASSERT_EQ(bits(both.sin), bits(sin(x))) << x;
      ASSERT_EQ(bits(both.cos), bits(cos(x))) << x;
    }
}

TEST(Math, FunctionsAreMonotoneInSteps) {
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const double x = std::abs(argument(2, i) * 0x1p-20), next = std::nextafter(x, kInf);
    ASSERT_LE(exp(-next), exp(-x)) << x;
    ASSERT_LE(log(x), log(next)) << x;
    ASSERT_LE(log2(x), log2(next)) << x;
    ASSERT_LE(atan2(x, 1), atan2(next, 1)) << x;
    ASSERT_LE(pow(x, 1.25), pow(next, 1.25)) << x;
    const double angle = x < 1.5 ? x : 1 / x, more = std::nextafter(angle, kInf);
    ASSERT_LE(sin(angle), sin(more)) << x;
    ASSERT_GE(cos(angle), cos(more)) << x;
    if (more <= 1) {
      ASSERT_LE(asin(angle), asin(more)) << x;
      ASSERT_GE(acos(angle), acos(more)) << x;
    }
  }
}

/// Arguments whose results need most bits: from Lefevre and Muller (2001), and the double nearest
/// to a multiple of pi / 2 (Kahan 1983). The results are MPFR's.
TEST(Math, HardCasesAreRoundedCorrectly) {
  expect_bits({
      of(sin, 0x1.6ac5b262ca1ffp+849, 0x1p+0),
      of(cos, 0x1.6ac5b262ca1ffp+849, -0x1.14ae72e6ba22fp-61),
      of(sin, 0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53),
      of(cos, 0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54),
      of(sin, 0x1.0f0cf064dd592p+73, -0x1.b453ab76bf397p-1),
      of(cos, 0x1.fffffffffffffp+1023, -0x1.fffe62ecfab75p-1),
      of(sin, 0x1.e0000000001c2p-20, 0x1.dfffffffff02ep-20),
      of(cos, 0x1.8000000000009p-23, 0x1.fffffffffff7p-1),
      of(sin, 0x1.598bae9e632f6p-7, 0x1.598a0aea48996p-7),
      of(sin, 0x1.fe767739d0f6dp-2, 0x1.e9950730c4696p-2),
      of(cos, 0x1.8000000000003p-24, 0x1.fffffffffffdcp-1),
      of(exp, 0x1.9e9cbbfd6080bp-31, 0x1.000000033d398p+0),
      of(exp, 0x1.83d4bcdebb3f4p+2, 0x1.ac50b409c8aeep+8),
      of(exp, 0x1p-53, 0x1.0000000000001p+0),
      of(exp, -0x1p-54, 0x1p+0),
      of(exp, 0x1.fffffffffffffp-53, 0x1.0000000000001p+0),
      of(exp, 0x1.62e42fefa39efp+9, 0x1.fffffffffff2ap+1023),
      of(exp, 0x1.62e42fefa39fp+9, kInf),
      of(exp, -0x1.74910d52d3051p+9, 0x0.0000000000001p-1022),
      of(exp, -0x1.74910d52d3052p+9, 0x0p+0),
      of(exp, 0x1.8000000000003p-43, 0x1.00000000003p+0),
      of(log, 0x1.62a88613629b5p+678, 0x1.d6479eba7c971p+8),
      of(log, 0x1.c7e1077f9aec1p-1, -0x1.db88b11605254p-4),
      of(log, 0x1.ab50b409c8aeep+8, 0x1.83ae70db9a9ccp+2),
      of(log, 0x1.0000000000001p+0, 0x1.fffffffffffffp-53),
      of(log, 0x1.fffffffffffffp-1, -0x1p-53),
      of(log, 0x0.0000000000001p-1022, -0x1.74385446d71c3p+9),
      of(log2, 0x1.0000000000001p+0, 0x1.71547652b82fdp-52),
      of(log2, 0x1.b4ebe40c95a01p+0, 0x1.8adeac981e00ep-1),
      of(log2, 0x1.61555f75885b4p+255, 0x1.feee05a07a6e8p+7),
      of(asin, 0x1.7718543a5606ap-1, 0x1.a4f02f7d4fcacp-1),
      of(asin, 0x1.6c042a6378102p-23, 0x1.6c042a6378121p-23),
      of(asin, 0x1.fffffffffffffp-1, 0x1.921fb50442d18p+0),
      of(acos, 0x1.fffffffffffffp-1, 0x1p-26),
      of(acos, -0x1.fffffffffffffp-1, 0x1.921fb52442d18p+1),
      of(acos, 0x1.53ea6c7255e88p-4, 0x1.7cdacb6bbe707p+0),
      of(acos, 0x1.fd737be914578p-11, 0x1.91e006d41d8d9p+0),
  });
}

TEST(Math, HypotHasTheBitsOfItsTable) {
  expect_bits({
      of(hypot, 0x1.89d9e7cdf5a37p-1, -0x1.ae82ea9a66625p-3, 0x1.984acd4370717p-1),
      of(hypot, -0x1.3bb7798fc8a56p+0, 0x1.53bb55d16dd2cp+1, 0x1.769d9ffe5e129p+1),
      of(hypot, -0x1.99c0d80740aa3p+0, 0x1.5e4e30d52a44p+1, 0x1.95d16f8d0ef33p+1),
      of(hypot, -0x1.16cef2fa79c1ep+5, 0x1.2afc2b40439d5p+6, 0x1.49e3213288e4dp+6),
      of(hypot, -0x1.3134db3fbe541p+6, -0x1.1266c1de6d578p+2, 0x1.31b01cab703d2p+6),
      of(hypot, -0x1.303e7ac9c062cp-28, -0x1.30f1f33f80d91p-30, 0x1.39a6707be55b9p-28),
      of(hypot, 0x1.dda600ecab521p-30, 0x1.beb62f912b6f9p-39, 0x1.dda6352592e82p-30),
      of(hypot, 0x1.5463966058047p+22, 0x1.1e2be8f85d6bdp-30, 0x1.5463966058047p+22),
      of(hypot, 0x1.550864b43e39ep+838, 0x1.60560198a327dp+840, 0x1.6a812ded0e31p+840),
      of(hypot, -0x1.04ea8ba411193p+850, -0x1.8dee5b5baebebp+854, 0x1.8e43dc287e827p+854),
      of(hypot, 0x1.0000000000001p+693, 0x1.ffffffffffffep+636, 0x1.0000000000001p+693),
      of(hypot, 0x1.ffffffffffffap-390, -0x1.ffffffffffffep-309, 0x1.ffffffffffffep-309),
      of(hypot, -0x1.64cbccbc6a2f6p+1, -0x1.9449a7ee6aff8p+0, 0x1.9a1479b44f14ep+1),
      of(hypot, -0x1.d3d48167ec363p+0, 0x1.4b9e6432e90fbp+1, 0x1.95d115a40e068p+1),
      of(hypot, 0x1.8f397c5527b3ep+1, -0x1.c4c25ec733556p-1, 0x1.9ef5e04c6a909p+1),
      of(hypot, -0x1.2979f776670cp+6, -0x1.d95d0e4e37d8ep+5, 0x1.7c2534e7df157p+6),
      of(hypot, 0x1.b050607c95af4p+4, -0x1.d42d1c5c65094p+5, 0x1.01d56b8a06884p+6),
      of(hypot, -0x1.677af094cfa3dp+5, 0x1.faa975bc0e1d8p+37, 0x1.faa975bc0e1d8p+37),
      of(hypot, 0x1.03e49c9ea73c4p+1, 0x1.b06423f4ee058p-25, 0x1.03e49c9ea73c5p+1),
      of(hypot, 0x1.2a9ea653cd473p-28, -0x1.4a37a648e20cap-36, 0x1.2a9f5ce7ddd85p-28),
      of(hypot, 0x1.233eac417e459p+537, 0x1.f59a093d5ea1cp+541, 0x1.f5ee8f9b117dbp+541),
      of(hypot, -0x1.8e3cd3d83de74p+992, -0x1.412adf05e175dp+991, 0x1.ad6532a7b0d91p+992),
      of(hypot, -0x1.ffffffffffffep+53, 0x1.ffffffffffffep-930, 0x1.ffffffffffffep+53),
      of(hypot, -0x1.0000000000001p-843, 0x1.0000000000001p+697, 0x1.0000000000001p+697),
      of(hypot, 0x1.8p+1, 0x1p+2, 0x1.4p+2),
      of(hypot, 0x1.fffffffffffffp+1023, 0x1p+1000, kInf),
      of(hypot, 0x0.0000000000001p-1022, 0x0.0000000000001p-1022, 0x0.0000000000001p-1022),
      of(hypot, 0x1p-1022, 0x0.cp-1022, 0x1.4p-1022),
      of(hypot, 0x1.fffffffffffffp+1022, 0x1.fffffffffffffp+1022, 0x1.6a09e667f3bccp+1023),
      of(hypot, 0x1p+0, 0x1p-54, 0x1p+0),
      of(hypot, 0x1p+0, 0x1p-27, 0x1p+0),
      of(hypot, 0x1p+511, 0x1p+511, 0x1.6a09e667f3bcdp+511),
      of(hypot, 0x1p-459, 0x1.8p-459, 0x1.cd82b446159f3p-459),
  });
}

#if defined(__x86_64__) && defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 35)
TEST(Math, HypotHasTheBitsOfGlibcOnX86) {
  for (int kind = 0; kind < kKinds; ++kind)
    for (std::uint64_t i = 0; i < 125'000; ++i) {
      const double x = argument(kind, i);
      const double y =
          kind == 4 && i % 2 == 0 ? of_bits(bits(x) ^ mix(i) >> 9) : argument(kind, i, 1);
      ASSERT_EQ(bits(hypot(x, y)), bits(std::hypot(x, y))) << std::hexfloat << x << " " << y;
    }
}
#endif
#endif

#ifdef SLALOM_HAS_MPFR
struct Reference {
  const char* name;
  OfOne one;
  OfTwo two;
  int (*mpfr_one)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  int (*mpfr_two)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
};

class MathAgainstMpfr : public testing::TestWithParam<Reference> {
 public:
  void SetUp() override {
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
    mpfr_inits2(53, x_, y_, result_, static_cast<mpfr_ptr>(nullptr));
  }
  void TearDown() override {
    mpfr_clears(x_, y_, result_, static_cast<mpfr_ptr>(nullptr));
    mpfr_free_cache();
  }

  double correct(double x, double y) {
    mpfr_set_d(x_, x, MPFR_RNDN);
    mpfr_set_d(y_, y, MPFR_RNDN);
    const Reference& f = GetParam();
    int inexact = f.mpfr_one != nullptr ? f.mpfr_one(result_, x_, MPFR_RNDN)
                                        : f.mpfr_two(result_, x_, y_, MPFR_RNDN);
    inexact = mpfr_check_range(result_, inexact, MPFR_RNDN);
    mpfr_subnormalize(result_, inexact, MPFR_RNDN);
    return mpfr_get_d(result_, MPFR_RNDN);
  }

  void compare(double x, double y) {
    const Reference& f = GetParam();
    ASSERT_EQ(bits(f.one != nullptr ? f.one(x) : f.two(x, y)), bits(correct(x, y)))
        << std::hexfloat << x << " " << y;
  }

 private:
  mpfr_t x_, y_, result_;
};

TEST_P(MathAgainstMpfr, IsRoundedCorrectly) {
  for (int kind = 0; kind < kKinds; ++kind)
    for (std::uint64_t i = 0; i < 25'000; ++i) {
      const double x = argument(kind, i), scale = kind == 0 ? 3.141592653589793 : 100;
      ASSERT_NO_FATAL_FAILURE(compare(x, argument(kind, i, 1)));
      if (kind > 1) continue;
      ASSERT_NO_FATAL_FAILURE(compare(x / scale, argument(2, i)));  // in the domain of arcs
    }
}

INSTANTIATE_TEST_SUITE_P(All, MathAgainstMpfr,
                         testing::Values(Reference{"sin", sin, nullptr, mpfr_sin, nullptr},
                                         Reference{"cos", cos, nullptr, mpfr_cos, nullptr},
                                         Reference{"asin", asin, nullptr, mpfr_asin, nullptr},
                                         Reference{"acos", acos, nullptr, mpfr_acos, nullptr},
                                         Reference{"exp", exp, nullptr, mpfr_exp, nullptr},
                                         Reference{"log", log, nullptr, mpfr_log, nullptr},
                                         Reference{"log2", log2, nullptr, mpfr_log2, nullptr},
                                         Reference{"pow", nullptr, pow, nullptr, mpfr_pow},
                                         Reference{"atan2", nullptr, atan2, nullptr, mpfr_atan2}),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// Covers e^x and x^y in the range of doubles, with the least of them.
TEST(Math, ExponentialsAreRoundedCorrectlyInTheirWholeRange) {
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
  mpfr_t x, y, result;
  mpfr_inits2(53, x, y, result, static_cast<mpfr_ptr>(nullptr));
  const auto rounded = [&](int inexact) {
    inexact = mpfr_check_range(result, inexact, MPFR_RNDN);
    mpfr_subnormalize(result, inexact, MPFR_RNDN);
    return mpfr_get_d(result, MPFR_RNDN);
  };
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const double power = argument(1, i) * 7.5;
    const double base = std::abs(argument(i % 2 == 0 ? 4 : 7, i, 1)), exponent = power / log(base);
    mpfr_set_d(x, power, MPFR_RNDN);
    ASSERT_EQ(exp(power), rounded(mpfr_exp(result, x, MPFR_RNDN))) << std::hexfloat << power;
    if (!(std::abs(exponent) < kInf)) continue;
    mpfr_set_d(x, base, MPFR_RNDN);
    mpfr_set_d(y, exponent, MPFR_RNDN);
    ASSERT_EQ(pow(base, exponent), rounded(mpfr_pow(result, x, y, MPFR_RNDN)))
        << std::hexfloat << base << " " << exponent;
  }
  mpfr_clears(x, y, result, static_cast<mpfr_ptr>(nullptr));
  mpfr_free_cache();
}
#else
TEST(Math, IsRoundedCorrectly) {
  GTEST_SKIP() << "needs the package libmpfr-dev";
}
#endif

}  // namespace
}  // namespace slalom::math
