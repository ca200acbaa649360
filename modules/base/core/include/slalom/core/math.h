// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace slalom::math {

/// Functions with the same bits on every machine: of + - * / and sqrt of doubles, of integers and
/// of tables (scripts/math_tables.py), with rounding to nearest and without fused multiply-add
/// (-ffp-contract=off). The C library's have other bits where the processor, the library or the
/// compiler differs. Angles are in radians. Arguments are all doubles; zeros, infinities, NaN and
/// signs are as in Annex F of C. Neither errno nor exceptions of floating point are promised.
///
/// All but hypot() round correctly: each result is the double nearest to the true value, ties to
/// even, as IEEE 754-2019, 9.2 recommends. A fast phase (tables and short polynomials in pairs of
/// doubles; Dekker 1971, Tang 1989 to 1992) has a relative error below 2^-65, 2^-64.6 in pow():
/// estimated in math.cpp, and below 0.4 of the estimate in 2 million arguments of each function.
/// Where that error leaves the rounding open (Ziv 1991), 1 of 400 to 7000 arguments, a phase with
/// integers of 256 bits decides, after a reduction of Payne and Hanek (1983) if the angle is large.
/// Its error is below 2^-180, in exact cases of pow() below 2^-220; values within 2^-201 of a
/// double or of the midpoint of two count as equal to it, so that exact cases of pow() are right.
/// Not proven: that no other result is so close. The hardest known cases need 2^-160 (Lefevre and
/// Muller 2001). Tests compare with MPFR.
double sin(double x);
double cos(double x);
struct SinCos {
  double sin, cos;
};
SinCos sin_cos(double x);
double asin(double x);
double acos(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);
double log2(double x);
double pow(double x, double y);

/// Length of the vector (x, y): within one unit in the last place, nearest in 99.5 % (Borges 2020).
/// Bits are those of glibc 2.35 or later on x86-64.
double hypot(double x, double y);

}  // namespace slalom::math
