#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes modules/base/core/src/math_tables.h, the tables of slalom/core/math.h, from integer arithmetic alone.

Fixed-point integers of 1600 bits stand for real numbers; every series is summed until its terms vanish.
  scripts/math_tables.py > modules/base/core/src/math_tables.h
"""

from fractions import Fraction

BITS = 1600
ONE = 1 << BITS


def mul(a, b):
    return a * b >> BITS


def atan_inverse(n):
    """Returns the angle whose tangent is 1/n (Gregory's series)."""
    term, total, k = ONE // n, 0, 0
    while term:
        total += (-1) ** k * term // (2 * k + 1)
        term //= n * n
        k += 1
    return total


PI = 4 * (4 * atan_inverse(5) - atan_inverse(239))  # Machin 1706


def exp(x):
    term, total, k = ONE, 0, 0
    while term:
        total += term
        k += 1
        term = mul(term, x) // k if x >= 0 else -(mul(term, x) // -k)
    return total


def log_ratio(p, q):
    """Returns log(p/q), p and q integers, from 2 artanh((p - q) / (p + q))."""
    z = ONE * (p - q) // (p + q)
    z2, power, total, k = mul(z, z), z, 0, 1
    while abs(power) > 1:
        total += power // k
        power = mul(power, z2)
        k += 2
    return 2 * total


LN2 = log_ratio(2, 1)


def sin(x):
    term, total, k, x2 = x, 0, 1, mul(x, x)
    while abs(term) > 1:
        total += term
        term = -mul(term, x2) // ((k + 1) * (k + 2))
        k += 2
    return total


def atan(p, q):
    """Returns the angle whose tangent is p/q <= 1, by Euler's series."""
    z = ONE * p * p // (p * p + q * q)
    term, total, k = ONE * p * q // (p * p + q * q), 0, 1
    while term:
        total += term
        term = mul(term, z) * (2 * k) // (2 * k + 1)
        k += 1
    return total


def to_double(x):
    return float(Fraction(x, ONE))  # rounds to nearest


def multiple(x, exponent):
    """Returns x rounded to a multiple of 2^exponent."""
    unit = 1 << (BITS + exponent)
    return (x + unit // 2) // unit * unit


def head(x, bits):
    """Returns x rounded to so many bits."""
    return multiple(x, x.bit_length() - BITS - bits) if x else 0


def parts(x, *heads):
    """Returns doubles whose sum is x: each of so many bits, then the rest."""
    result = []
    for bits in heads:
        h = head(x, bits) if x >= 0 else -head(-x, bits)
        result.append(to_double(h))
        x -= h
    return result + [to_double(x)]


def multiple_and_rest(x, exponent):
    h = multiple(x, exponent)
    return [to_double(h), to_double(x - h)]


def wide(x):
    """Returns the initializer of a Wide."""
    exponent = x.bit_length() - BITS
    m = x >> (x.bit_length() - 256) if x.bit_length() >= 256 else x << (256 - x.bit_length())
    words = ", ".join(f"0x{m >> 64 * (3 - i) & (1 << 64) - 1:016x}" for i in range(4))
    return f"{{false, {exponent}, {{{words}}}}}"


def row(doubles):
    return "{" + ", ".join(d.hex() for d in doubles) + "}"


def table(comment, declaration, rows):
    print(f"\n// {comment}")
    print(f"constexpr {declaration} = {{")
    for r in rows:
        print(f"    {r},")
    print("};")


def log_rows():
    rows = []
    for i in range(256):
        low, high = Fraction(256 + i, 256), Fraction(257 + i, 256)
        def far(n):
            return max(abs(low * n / 512 - 1), abs(high * n / 512 - 1))
        c = min(range(256, 513), key=far) if i else 512
        assert far(c) <= Fraction(1, 256)
        log = log_ratio(512, c) - (LN2 if i >= 106 else 0)
        values = multiple_and_rest(log, -42)
        assert log == 0 and c in (256, 512) or abs(values[0]) >= 1.9 / 512
        rows.append(row([c / 512] + values))
    return rows


def constants():
    for name, x, heads in (
        ("kPiOver256", PI // 256, (33, 33)),
        ("kLn2Over128", LN2 // 128, (36, 36)),
        ("kInverseLn2", ONE * ONE // LN2, (53,)),
        ("kThird", ONE // 3, (53,)),
    ):
        print(f"constexpr double {name}[] = {row(parts(x, *heads))};")
    print(f"constexpr double kLn2[] = {row(multiple_and_rest(LN2, -42))};")
    print(f"constexpr double kHalfPi[] = {row(multiple_and_rest(PI // 2, -50))};")
    print(f"constexpr double kThreeQuartersPi = {to_double(3 * PI // 4).hex()};")
    for name, x in (("kWideLn2", LN2), ("kWideInverseLn2", ONE * ONE // LN2),
                    ("kWideHalfPi", PI // 2), ("kWidePi", PI)):
        print(f"constexpr Wide {name} =\n    {wide(x)};")


def main():
    print("// SPDX-License-Identifier: BSD-3-Clause\n"
          "// Written by scripts/math_tables.py; included by math.cpp only.\n// clang-format off\n")
    constants()
    two_over_pi = 2 * ONE * ONE // PI
    words = [two_over_pi >> (BITS - 64 * (i + 1)) & (1 << 64) - 1 for i in range(22)]
    table("Words of 2 / pi after the binary point.", "std::uint64_t kTwoOverPi[22]",
          [", ".join(f"0x{w:016x}" for w in words[i:i + 4]) for i in range(0, 22, 4)])
    factorial, rows = 1, []
    for n in range(59):
        factorial *= max(n, 1)
        rows.append(wide(ONE // factorial))
    table("1 / n!", "Wide kInverseFactorials[59]", rows)
    table("sin(i pi / 256): 27 bits and the rest.", "Split kSines[129]",
          [row(parts(sin(PI * i // 256), 27)) for i in range(129)])
    table("2^(i / 128): 27 bits and the rest.", "Split kPowers[128]",
          [row(parts(exp(LN2 * i // 128), 27)) for i in range(128)])
    table("atan(i / 128): a multiple of 2^-50 and the rest.", "Split kArcs[129]",
          [row(multiple_and_rest(atan(i, 128), -50)) for i in range(129)])
    table("For m from 1 + i / 256 to 1 + (i + 1) / 256: c with |m c - 1| <= 1/256, a multiple of 1/512, and"
          "\n// -log(c), from i = 106 on -log(2 c): a multiple of 2^-42 and the rest.",
          "Logarithm kLogarithms[256]", log_rows())


main()
