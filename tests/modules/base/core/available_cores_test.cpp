// SPDX-License-Identifier: BSD-3-Clause
#include "temporary_folder.h"

#include <slalom/core/available_cores.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sched.h>

namespace slalom {
namespace {

TEST(AvailableCores, AreAtMostThoseOfTheAffinity) {
  cpu_set_t all;
  ASSERT_EQ(sched_getaffinity(0, sizeof(all), &all), 0);
  EXPECT_GE(available_cores(), 1);
  EXPECT_LE(available_cores(), CPU_COUNT(&all));
  int first = 0;
  while (!CPU_ISSET(first, &all)) ++first;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
  EXPECT_EQ(available_cores(), 1);
  EXPECT_EQ(worker_count(0), 1);
  EXPECT_EQ(worker_count(7), 7) << "more than there are, as wanted";
  ASSERT_EQ(sched_setaffinity(0, sizeof(all), &all), 0);
}

/// Folders of control groups as in /sys/fs/cgroup.
class QuotaOfGroup : public testing::Test {
 protected:
  void write(const std::string& group, const std::string& cpu_max) const {
    const std::string folder = folder_ / group;
    std::filesystem::create_directories(folder);
    std::ofstream(folder + "/cpu.max") << cpu_max;
  }
  std::optional<int> of(const std::string& group) const {
    return quota_of_group(folder_ / "", group);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(QuotaOfGroup, IsRoundedUp) {
  write("job", "150000 100000\n");
  EXPECT_EQ(of("/job"), 2);
  write("job", "1000 100000\n");
  EXPECT_EQ(of("/job"), 1);
  write("job", "400000 100000\n");
  EXPECT_EQ(of("/job"), 4);
}

TEST_F(QuotaOfGroup, IsTheSmallestOfAllThatContainIt) {
  write("", "800000 100000\n");  // that of a container is at the root
  EXPECT_EQ(of("/"), 8);
  write("slice/job", "max 100000\n");
  EXPECT_EQ(of("/slice/job"), 8);
  write("slice", "300000 100000\n");
  EXPECT_EQ(of("/slice/job"), 3);
  EXPECT_EQ(of("/other"), 8);
}

TEST_F(QuotaOfGroup, IsNoneIfThereIsNoneOrItIsMalformed) {
  EXPECT_EQ(of("/"), std::nullopt);
  EXPECT_EQ(of("/none/at/all"), std::nullopt);
  for (const char* text : {"max 100000\n", "", "100000", "100000 0\n", "-1 100000\n", "a b"}) {
    write("job", text);
    EXPECT_EQ(of("/job"), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace slalom
