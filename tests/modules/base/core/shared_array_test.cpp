// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/shared_array.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(SharedArray, HoldsTheElementsOfAVectorWithoutCopyingThem) {
  std::vector<int> elements = {4, 7, 9};
  const int* memory = elements.data();
  const SharedArray<int> array(std::move(elements));
  EXPECT_EQ(array.data(), memory);
  EXPECT_EQ(array.size(), 3U);
  EXPECT_EQ(array[1], 7);
  EXPECT_EQ(std::vector<int>(array.begin(), array.end()), (std::vector<int>{4, 7, 9}));
}

TEST(SharedArray, CopiesKeepTheMemoryUntilTheLastOfThem) {
  bool released = false;
  const int memory[] = {1, 2};
  {
    SharedArray<int> copy;
    EXPECT_EQ(copy.size(), 0U);
    copy = SharedArray<int>({memory, [&](const int*) { released = true; }}, 2);
    EXPECT_FALSE(released);
    EXPECT_EQ(copy[1], 2);
  }
  EXPECT_TRUE(released);
}

}  // namespace
}  // namespace slalom
