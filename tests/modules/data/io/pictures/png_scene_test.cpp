// SPDX-License-Identifier: BSD-3-Clause
#include "memory_folder.h"

#include <slalom/io/png_scene.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
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
  EXPECT_EQ(color(248, 150),
            0x4b2e83);  // on the line to (300, 150), 98 = 16 * 6 + 2 from its begin
  EXPECT_EQ(color(245, 150), 0xffffff);  // 95 = 15 * 6 + 5: in a gap
  EXPECT_EQ(color(250, 140), 0xffffff);
  std::filesystem::remove_all(folder);
}

TEST(PngScene, ReferencesHaveTheColorsAndDashesOfTheSvg) {
  const Scenario scenario = Scenario::continuous("s", {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3});
  References references;
  references.shortest.emplace().path = {{1, 1}, {7, 1}};
  references.safest.emplace().path = {{1, 2}, {7, 2}};
  SceneOptions options;
  options.max_pixels = 400;  // 50 pixels per meter
  options.references = &references;
  const std::string svg = render_svg(scenario, options);
  std::string pattern = (memory_folder() / "slalom_png_XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(pattern.data());
  render_png(scenario, options, (folder / "scene.png").string());
  mrpt::img::CImage image;
  ASSERT_TRUE(image.loadFromFile((folder / "scene.png").string()));
  std::filesystem::remove_all(folder);
  const struct {
    std::string name;
    unsigned y;
  } lines[] = {{"shortest", 150}, {"safest", 100}};
  for (const auto& line : lines) {
    const std::string& name = line.name;
    const unsigned y = line.y;
    std::smatch style;
    ASSERT_TRUE(std::regex_search(
        svg, style,
        std::regex(name + "\"[^>]*stroke=\"#(\\w+)\"[^>]*dasharray=\"(\\d+) (\\d+)\"")));
    const unsigned long color = std::stoul(style[1], nullptr, 16);
    const double period = std::stod(style[2]) + std::stod(style[3]);
    int dashes = 0;
    for (unsigned x = 50, last = 0; x <= 350; ++x) {
      const auto at = [&](int channel) { return image(x, y, channel)[0]; };
      const unsigned found = at(2) << 16 | at(1) << 8 | at(0);
      dashes += found == color && last != color ? 1 : 0;
      last = found;
    }
    EXPECT_NEAR(dashes, 300 / period, 1) << name;
  }
}

}  // namespace
}  // namespace slalom
