#include <slalom/core/hash.h>

#include <gtest/gtest.h>

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

TEST(Hasher, TextsDoNotRunIntoEachOther) {
  EXPECT_NE(Hasher().add("ab").add("c").hex(), Hasher().add("a").add("bc").hex());
}

TEST(Hasher, CanBeReadInTheMiddleAndGoOn) {
  Hasher hasher;
  hasher.add("a");
  EXPECT_EQ(hasher.hex(), Hasher().add("a").hex());
  EXPECT_EQ(hasher.add("b").hex(), Hasher().add("a").add("b").hex());
}

}  // namespace
}  // namespace slalom
