// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace slalom {
namespace {

TEST(Random, TheEngineIsTheStandardMersenneTwister) {
  // C++ standard, [rand.predef]: the 10000th value of a default mt19937_64.
  RandomEngine engine;
  engine.discard(9999);
  EXPECT_EQ(engine(), 9981545732273789042ULL);
}

TEST(Random, NumbersStayInTheirRange) {
  RandomEngine engine(7);
  std::set<int> seen;
  for (int i = 0; i < 2000; ++i) {
    const double real = uniform_real(engine, -2, 3);
    EXPECT_GE(real, -2);
    EXPECT_LT(real, 3);
    seen.insert(uniform_int(engine, 1, 6));
  }
  EXPECT_EQ(seen, (std::set<int>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(uniform_real(engine, 4, 4), 4);
}

TEST(Random, NormalHasItsMeanAndDeviation) {
  RandomEngine engine(1);
  double sum = 0, squares = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double x = normal(engine, 3, 2);
    sum += x;
    squares += (x - 3) * (x - 3);
  }
  // Standard errors: 2/sqrt(20000) = 0.014 and about 0.01; tolerance 5 of them.
  EXPECT_NEAR(sum / kCount, 3, 0.07);
  EXPECT_NEAR(std::sqrt(squares / kCount), 2, 0.05);
}

TEST(Random, DerivedSeedsDifferByLabelIndexAndParent) {
  const std::set<std::uint64_t> seeds = {derive_seed(1, "a"), derive_seed(1, "b"),
                                         derive_seed(1, "a", 1), derive_seed(2, "a"),
                                         derive_seed(1, "")};
  EXPECT_EQ(seeds.size(), 5U);
  EXPECT_EQ(derive_seed(1, "a"), derive_seed(1, "a", 0));
}

}  // namespace
}  // namespace slalom
