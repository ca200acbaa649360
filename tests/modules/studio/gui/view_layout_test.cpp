// SPDX-License-Identifier: BSD-3-Clause
#include "views/view_layout.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

const std::vector<ViewLayout::Button> kButtons = {
    {"tool look", "Look"}, {"tool polygon", "+ Polygon"}, {"fit", "Fit"}};
const std::vector<std::string> kLayers = {"obstacles", "voronoi", "start_goal"};

bool overlap(const ScreenRect& a, const ScreenRect& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height &&
         b.top < a.top + a.height;
}

void expect_apart_and_inside(const ViewLayout& layout, double width, double height) {
  const auto& parts = layout.parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_GE(parts[i].rect.left, 0) << parts[i].name;
    EXPECT_GE(parts[i].rect.top, 0) << parts[i].name;
    EXPECT_LE(parts[i].rect.left + parts[i].rect.width, width) << parts[i].name;
    EXPECT_LE(parts[i].rect.top + parts[i].rect.height, height) << parts[i].name;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(overlap(parts[i].rect, parts[j].rect)) << parts[i].name << " " << parts[j].name;
  }
}

TEST(ViewLayout, HasToolsAboveTheCanvasAndAStatusLineBelow) {
  const ViewLayout layout(800, 500, kButtons, kLayers);
  expect_apart_and_inside(layout, 800, 500);
  EXPECT_DOUBLE_EQ(layout.canvas.top, layout.tools.height);
  EXPECT_DOUBLE_EQ(layout.canvas.top + layout.canvas.height, layout.status.top);
  EXPECT_DOUBLE_EQ(layout.status.top + layout.status.height, 500);
}

TEST(ViewLayout, LeavesTheLegendOutOfTheOpenCanvasIfThereIsSpace) {
  const ViewLayout wide(800, 500, kButtons, kLayers);
  EXPECT_FALSE(overlap(wide.open_canvas(), wide.legend));
  EXPECT_GT(wide.open_canvas().width, 500);
  const ViewLayout narrow(400, 500, kButtons, kLayers), closed(800, 500, kButtons, {});
  EXPECT_DOUBLE_EQ(narrow.open_canvas().width, 400);
  EXPECT_DOUBLE_EQ(closed.open_canvas().width, 800);
  EXPECT_FALSE(overlap(wide.scale_bar, wide.status));
}

TEST(ViewLayout, WrapsButtonsInANarrowView) {
  const ViewLayout wide(800, 500, kButtons, {}), narrow(120, 500, kButtons, {});
  expect_apart_and_inside(narrow, 120, 500);
  EXPECT_GT(narrow.tools.height, wide.tools.height);
}

TEST(ViewLayout, FindsThePartAtAPosition) {
  const ViewLayout layout(800, 500, kButtons, kLayers);
  for (const Element::Part& part : layout.parts) {
    const Element::Part* found =
        layout.at(part.rect.left + 0.5 * part.rect.width, part.rect.top + 0.5 * part.rect.height);
    ASSERT_NE(found, nullptr) << part.name;
    EXPECT_EQ(found->name, part.name);
  }
  EXPECT_EQ(layout.at(100, 300), nullptr);
}

TEST(ViewLayout, HidesTheRowsOfAClosedLegend) {
  EXPECT_EQ(ViewLayout(800, 500, kButtons, {}).find("layer voronoi"), nullptr);
}

TEST(ViewLayout, NeverCutsTheLegend) {
  const std::vector<std::string> layers = {"a", "b", "c", "d", "e", "f", "g", "h", "i"};
  // The canvas of the smallest window, 640 x 480, with results is about 380 x 140 pixels.
  for (const double width : {380.0, 500.0, 1500.0})
    for (const double height : {160.0, 200.0, 250.0, 900.0}) {
      const ViewLayout layout(width, height, kButtons, layers);
      for (const std::string& layer : layers) {
        const Element::Part* row = layout.find("layer " + layer);
        ASSERT_NE(row, nullptr) << layer << " in " << width << " x " << height;
        EXPECT_GE(row->rect.height, 15);
        EXPECT_LE(row->rect.bottom(), layout.canvas.bottom());
      }
      expect_apart_and_inside(layout, width, height);
    }
  // 24 pixels of title, nine rows of 22: one column in 900 pixels, as wide as is asked for.
  const ViewLayout tall(1500, 900, kButtons, layers, 320);
  EXPECT_DOUBLE_EQ(tall.legend.width, 320);
  EXPECT_DOUBLE_EQ(tall.legend.height, 24 + 9 * 22);
  // 34 of tools, 24 of status, 8 of gaps and 24 of title leave 70 of 160: at most 4 rows of 15.
  EXPECT_DOUBLE_EQ(ViewLayout(1500, 160, kButtons, layers).legend.width, 3 * 250);
}

}  // namespace
}  // namespace slalom
