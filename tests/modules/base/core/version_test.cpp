// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/version.h>

#include <gtest/gtest.h>
#include <mrpt/version.h>

namespace slalom {
namespace {

TEST(MrptVersion, IsReadFromBothOfItsEncodings) {
  // The examples of MRPT's version.h: a digit each in 2.5.8, two digits each in 2.14.7.
  EXPECT_EQ(mrpt_version(0x120), "1.2.0");
  EXPECT_EQ(mrpt_version(0x25B), "2.5.11");
  EXPECT_EQ(mrpt_version(0x020A02), "2.10.2");
  EXPECT_EQ(mrpt_version(0x20e07), "2.14.7");
}

TEST(MrptVersion, IsThatOfTheHeaders) {
  EXPECT_EQ("MRPT " + mrpt_version(), MRPT_version_str);
}

}  // namespace
}  // namespace slalom
