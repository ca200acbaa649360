// SPDX-License-Identifier: BSD-3-Clause
#include "thin_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slalom {
namespace {

using Indexes = std::vector<std::size_t>;

std::vector<double> count_up(std::size_t n, double step = 1) {
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(step * static_cast<double>(i));
  return values;
}

TEST(ThinSamples, KeepTheEndsOfALineAndTheSampleThatIsAskedFor) {
  const Signal line{count_up(100, 3), 1e-6};
  EXPECT_EQ(thin_samples(count_up(100), {line}, 0), (Indexes{0, 99}));
  EXPECT_EQ(thin_samples(count_up(100), {line}, 40), (Indexes{0, 40, 99}));
  EXPECT_EQ(thin_samples({2}, {{{5}, 1}}, 0), (Indexes{0}));
  EXPECT_EQ(thin_samples({}, {{{}, 1}}, 0), Indexes{});
}

TEST(ThinSamples, KeepTheCornersOfAnySignal) {
  const Signal line{count_up(7), 0.01}, corner{{0, 0, 0, 0, 1, 2, 3}, 0.01};
  EXPECT_EQ(thin_samples(count_up(7), {line, corner}, 0), (Indexes{0, 3, 6}));
}

TEST(ThinSamples, InterpolationStaysWithinTheTolerance) {
  const std::size_t n = 1001;
  const double step = 2 * M_PI / 1000, tolerance = 0.01;
  const std::vector<double> times = count_up(n, step);
  Signal sine{{}, tolerance};
  for (const double t : times) sine.values.push_back(std::sin(t));
  const Indexes kept = thin_samples(times, {sine}, 0);
  for (std::size_t k = 1; k < kept.size(); ++k) {
    const std::size_t from = kept[k - 1], to = kept[k];
    for (std::size_t i = from; i <= to; ++i) {
      const double fraction = static_cast<double>(i - from) / static_cast<double>(to - from);
      EXPECT_NEAR(sine.values[i],
                  sine.values[from] + fraction * (sine.values[to] - sine.values[from]),
                  tolerance + 1e-12);
    }
  }
  // A chord over h departs from a curve by at most h^2 / 8 times the second derivative, here at
  // most 1: 23 chords are enough.
  EXPECT_LE(kept.size(), 24U);
  EXPECT_EQ(kept.back(), n - 1);
}

TEST(ThinSamples, KeepWhatCannotBeInterpolated) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(thin_samples(count_up(6), {{{0, 0, nan, 0, 0, 0}, 1}}, 0), (Indexes{0, 1, 2, 3, 5}));
  EXPECT_EQ(thin_samples({0, 1, 1, 2, 3}, {{{0, 0, 9, 9, 9}, 1}}, 0), (Indexes{0, 1, 2, 4}));
}

}  // namespace
}  // namespace slalom
