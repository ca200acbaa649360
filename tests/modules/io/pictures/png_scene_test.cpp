// SPDX-License-Identifier: BSD-3-Clause
#include "memory_folder.h"

#include <slalom/io/png_scene.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <unistd.h>

namespace slalom {
namespace {

TEST(PngScene, PeopleAreDrawnAtTheirStartWithTheirRoutes) {
  std::string pattern = (memory_folder() / "slalom_png_XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(pattern.data());
  const Scenario scenario = Scenario::continuous("s", {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3})
                                .with_people({{"p", 0.5, 1, {3, 1}, {{6, 1}}}});
  SceneOptions options;
  options.max_pixels = 400;  // 50 pixels per meter
  const std::string path = (folder / "scene.png").string();
  render_png(scenario, options, path);
  mrpt::img::CImage image;
  ASSERT_TRUE(image.loadFromFile(path));
  const auto color = [&image](unsigned x, unsigned y) {  // #RRGGBB as a number; bytes are BGR
    return image(x, y, 2)[0] << 16 | image(x, y, 1)[0] << 8 | image(x, y, 0)[0];
  };
  EXPECT_EQ(color(160, 140), 0xa78bda);  // in the disc about (150, 150)
  EXPECT_EQ(color(250, 150), 0x4b2e83);  // on the line to (300, 150)
  EXPECT_EQ(color(250, 140), 0xffffff);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace slalom
