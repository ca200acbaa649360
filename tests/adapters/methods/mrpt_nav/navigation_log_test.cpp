// SPDX-License-Identifier: BSD-3-Clause
#include "navigator_fixture.h"

#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/nav/reactive/CLogFileRecord.h>
#include <mrpt/serialization/CArchive.h>

#include <filesystem>

namespace slalom {
namespace {

namespace fs = std::filesystem;
using mrpt::nav::CLogFileRecord;

std::string empty_folder(const std::string& name) {
  const std::string folder = testing::TempDir() + name;
  fs::remove_all(folder);
  return folder;
}

std::vector<CLogFileRecord::Ptr> read_log(const fs::path& path) {
  std::vector<CLogFileRecord::Ptr> records;
  mrpt::io::CFileGZInputStream file(path.string());
  auto archive = mrpt::serialization::archiveFrom(file);
  while (!file.checkEOF()) {
    try {
      records.push_back(archive.ReadObject<CLogFileRecord>());
    } catch (const mrpt::serialization::CExceptionEOF&) {
      break;
    }
  }
  return records;
}

SimulationResult run_with_seed(Method& method, std::uint64_t seed) {
  return simulate(navigator_room_with_discs(), RunSetup(), seed, method);
}

TEST(NavigationLog, ContainsEachStepOfEachRun) {
  const std::string folder = empty_folder("navlogs");
  const auto method =
      load_navigator_with(test_config("small_navigator.ini"), "record_navlog = " + folder + "\n");
  const SimulationResult first = run_with_seed(*method, 1);
  const SimulationResult second = run_with_seed(*method, 2);
  int files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    EXPECT_EQ(entry.path().extension(), ".reactivenavlog");
    const auto records = read_log(entry.path());
    // Both runs use the same world, and each cycle is a step.
    ASSERT_EQ(records.size(), first.cycle_seconds.size());
    ASSERT_FALSE(records[0]->infoPerPTG.empty());
    ASSERT_NE(records[0]->infoPerPTG[0].ptg, nullptr);  // used by viewers to draw the paths
    EXPECT_EQ(records[1]->infoPerPTG[0].ptg, nullptr);
    EXPECT_GT(records[0]->WS_Obstacles_original.size(), 10U);
    const auto& pose = records[5]->robotPoseLocalization;
    EXPECT_DOUBLE_EQ(pose.x, first.trajectory.samples[5].pose.x);
    ++files;
  }
  EXPECT_EQ(files, 2);
  EXPECT_EQ(second.trajectory.hash(), first.trajectory.hash());
}

TEST(NavigationLog, IsCompleteDuringTheRun) {
  const std::string folder = empty_folder("navlog_midway");
  const auto method =
      load_navigator_with(test_config("small_navigator.ini"), "record_navlog = " + folder + "\n");
  RunSetup setup;
  setup.simulation.max_time = 1.05;
  const auto result = simulate(navigator_room(), setup, 1, *method);
  // The method still exists, and so do its open files, if any.
  const auto records = read_log(fs::directory_iterator(folder)->path());
  EXPECT_EQ(records.size(), result.cycle_seconds.size());
}

TEST(NavigationLog, DoesNotAffectTheRunAndReplacesTheFileOfTheSameRun) {
  const std::string folder = empty_folder("navlog_again");
  const std::string config = test_config("small_navigator.ini");
  const auto logging = load_navigator_with(config, "record_navlog = " + folder + "\n");
  const auto plain = load_navigator_with(config);
  const std::string expected = run_with_seed(*plain, 1).trajectory.hash();
  EXPECT_EQ(run_with_seed(*logging, 1).trajectory.hash(), expected);
  const auto path = fs::directory_iterator(folder)->path();
  const std::size_t records = read_log(path).size();
  EXPECT_EQ(run_with_seed(*logging, 1).trajectory.hash(), expected);
  EXPECT_EQ(read_log(path).size(), records);
}

}  // namespace
}  // namespace slalom
