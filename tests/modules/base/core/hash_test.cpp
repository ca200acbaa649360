// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/hash.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slalom {
namespace {

TEST(Hasher, EmptyContentHasThePublishedXxh3Value) {
  // XXH3_128bits of no bytes, canonical: from the xxHash specification's test vectors.
  EXPECT_EQ(Hasher().hex(), "99aa06d3014798d86001c324468d497f");
}

TEST(Hasher, NegativeZeroIsZero) {
  EXPECT_EQ(Hasher().add(-0.0).hex(), Hasher().add(0.0).hex());
  EXPECT_NE(Hasher().add(1e-300).hex(), Hasher().add(0.0).hex());
}

TEST(Hasher, TextsAreSeparated) {
  EXPECT_NE(Hasher().add("ab").add("c").hex(), Hasher().add("a").add("bc").hex());
}

TEST(Hasher, HexDoesNotEndTheStream) {
  Hasher hasher;
  hasher.add("a");
  EXPECT_EQ(hasher.hex(), Hasher().add("a").hex());
  EXPECT_EQ(hasher.add("b").hex(), Hasher().add("a").add("b").hex());
}

TEST(SameBits, TellsZerosApartAndFindsANanEqualToItself) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(same_bits(0.1, 0.1));
  EXPECT_TRUE(same_bits(nan, nan));
  EXPECT_FALSE(same_bits(-0.0, 0.0));
  EXPECT_FALSE(same_bits(0.1, std::nextafter(0.1, 1.0)));
}

}  // namespace
}  // namespace slalom
