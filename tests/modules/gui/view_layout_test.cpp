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

TEST(ViewLayout, HidesRowsOfALegendThatIsClosedOrDoesNotFit) {
  EXPECT_EQ(ViewLayout(800, 500, kButtons, {}).find("layer voronoi"), nullptr);
  // 34 pixels of tools, 4 of gap, 24 of title, 22 per row, 24 of status: two rows in 140.
  const ViewLayout low(800, 140, kButtons, kLayers);
  EXPECT_NE(low.find("layer voronoi"), nullptr);
  EXPECT_EQ(low.find("layer start_goal"), nullptr);
  expect_apart_and_inside(low, 800, 140);
}

}  // namespace
}  // namespace slalom
