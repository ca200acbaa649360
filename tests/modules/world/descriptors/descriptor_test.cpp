// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "small_worlds.h"

#include <slalom/core/error.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(Descriptors, MeansAreNaWithoutFreeSpace) {
  const World world = drawn_world({"###", "###", "###"});
  EXPECT_DOUBLE_EQ(value_of("density", context_of(world)), 1);
  EXPECT_EQ(descriptor("clearness").compute(context_of(world)).reason(), "no free space");
  EXPECT_EQ(descriptor("confinement").compute(context_of(world)).reason(), "no free space");
}

TEST(Descriptors, UnknownIdsAreRejectedWithTheMostSimilar) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage,
                           "descriptor:", {"unknown id 'densty'", "expected 'density'"},
                           [] { descriptor("densty"); }));
}

}  // namespace
}  // namespace slalom
