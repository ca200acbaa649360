// SPDX-License-Identifier: BSD-3-Clause
#include "io_sample.h"

#include <slalom/io/temporary_list.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace slalom {
namespace {

TEST(TemporaryList, IsRemovedWithTheLastReference) {
  auto list = make_temporary_list();
  const std::filesystem::path file = list->path();
  list->add(sample_scenario(1));
  EXPECT_TRUE(std::filesystem::exists(file));
  const auto other = make_temporary_list();
  EXPECT_NE(other->path(), list->path());
  auto copy = list;
  list.reset();
  EXPECT_EQ(copy->size(), 1U);
  copy.reset();
  EXPECT_FALSE(std::filesystem::exists(file.parent_path()));
}

}  // namespace
}  // namespace slalom
