// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/studio/settings.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace slalom {
namespace {

class StudioSettingsTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string folder_ = testing::TempDir() + "slalom_studio_settings_" + std::to_string(getpid());
  std::string path_ = folder_ + "/deep/studio.ini";
};

TEST_F(StudioSettingsTest, AreReadAsWritten) {
  StudioSettings settings;
  settings.width = 1920;
  settings.list_width = 471;
  settings.grid = true;
  settings.legend = false;
  settings.theme = Theme::Light;
  settings.layers = "obstacles,voronoi";
  write_studio_settings(settings, path_);
  const StudioSettings read = read_studio_settings(path_);
  EXPECT_EQ(read.width, 1920);
  EXPECT_EQ(read.height, 800);
  EXPECT_EQ(read.list_width, 471);
  EXPECT_TRUE(read.grid);
  EXPECT_FALSE(read.legend);
  EXPECT_EQ(read.theme, Theme::Light);
  EXPECT_EQ(read.layers, "obstacles,voronoi");
}

TEST_F(StudioSettingsTest, KeepTheEightFilesThatWereOpenedLast) {
  StudioSettings settings;
  for (int i = 0; i < 9; ++i)
    remember_file(settings.recent, "/lists/" + std::to_string(i) + ".scenarios");
  remember_file(settings.recent, "/lists/../lists/3.scenarios");  // again
  remember_file(settings.recent, "runs, small.results");
  const std::string here = std::filesystem::current_path().string();
  const RecentFiles expected = {here + "/runs, small.results", "/lists/3.scenarios",
                                "/lists/8.scenarios",          "/lists/7.scenarios",
                                "/lists/6.scenarios",          "/lists/5.scenarios",
                                "/lists/4.scenarios",          "/lists/2.scenarios"};
  EXPECT_EQ(settings.recent, expected);
  for (const char* other : {"/a.yaml", "/a #1.scenarios", "/${a}.scenarios", "/a\nb.scenarios"})
    remember_file(settings.recent, other);
  EXPECT_EQ(settings.recent, expected) << "no list, or not to be written to an .ini";
  write_studio_settings(settings, path_);
  EXPECT_EQ(read_studio_settings(path_).recent, expected);
}

TEST_F(StudioSettingsTest, AreTheDefaultsWithoutAFile) {
  EXPECT_EQ(read_studio_settings(path_).width, StudioSettings().width);
}

TEST_F(StudioSettingsTest, ReportTheInvalidKey) {
  std::filesystem::create_directories(folder_ + "/deep");
  std::ofstream(path_) << "[window]\nwidth = 12\n";
  EXPECT_TRUE(throws_error(ErrorKind::Usage,
                           path_ + ":2: [window] width: ", {"'12'", "expected", "in [640, 8192]"},
                           [&] { read_studio_settings(path_); }));
}

}  // namespace
}  // namespace slalom
