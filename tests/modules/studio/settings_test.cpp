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
  settings.legend = false;
  settings.layers = "obstacles,voronoi";
  write_studio_settings(settings, path_);
  const StudioSettings read = read_studio_settings(path_);
  EXPECT_EQ(read.width, 1920);
  EXPECT_EQ(read.height, 800);
  EXPECT_EQ(read.list_width, 471);
  EXPECT_FALSE(read.legend);
  EXPECT_EQ(read.layers, "obstacles,voronoi");
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
