// SPDX-License-Identifier: BSD-3-Clause
#include "window/window_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace slalom {
namespace {

double area(const ScreenRect& rect) {
  return rect.width * rect.height;
}

double common_area(const ScreenRect& a, const ScreenRect& b) {
  const double width = std::min(a.left + a.width, b.left + b.width) - std::max(a.left, b.left);
  const double height = std::min(a.top + a.height, b.top + b.height) - std::max(a.top, b.top);
  return std::max(width, 0.0) * std::max(height, 0.0);
}

StudioSettings with_panels(int list_width, int descriptors_height, int results_height) {
  StudioSettings settings;
  settings.list_width = list_width;
  settings.descriptors_height = descriptors_height;
  settings.results_height = results_height;
  return settings;
}

const std::vector<std::pair<int, int>> kSizes = {{640, 480},   {800, 600},   {1024, 700},
                                                 {1280, 800},  {1920, 1080}, {3840, 2160},
                                                 {1000, 2000}, {2500, 500}};

/// The initial settings of the window, and the panels dragged to the limit in all directions.
std::vector<StudioSettings> settings_to_try() {
  std::vector<StudioSettings> all = {StudioSettings()};
  for (const int list_width : {0, 8192})
    for (const int descriptors_height : {0, 8192})
      for (const int results_height : {0, 8192})
        all.push_back(with_panels(list_width, descriptors_height, results_height));
  return all;
}

TEST(WindowLayouts, FillTheWindowWithoutOverlap) {
  for (const auto& [width, height] : kSizes)
    for (const StudioSettings& settings : settings_to_try())
      for (const BelowView below : {BelowView::Nothing, BelowView::Timeline, BelowView::Results}) {
        const ScreenRect window{0, 0, static_cast<double>(width), static_cast<double>(height)};
        const WindowLayout layout = lay_out_window(width, height, settings, below);
        const std::vector<std::pair<std::string, ScreenRect>> panels(layout.begin(), layout.end());
        EXPECT_EQ(panels.size(), 10U);
        double covered = 0;
        for (std::size_t i = 0; i < panels.size(); ++i) {
          covered += common_area(panels[i].second, window);
          for (std::size_t k = 0; k < i; ++k)
            EXPECT_EQ(common_area(panels[i].second, panels[k].second), 0)
                << panels[i].first << " and " << panels[k].first << " in " << width << " x "
                << height;
        }
        EXPECT_EQ(covered, area(window)) << width << " x " << height;
      }
}

TEST(WindowLayouts, GiveTheScenarioMoreThanAnyPanel) {
  for (const auto& [width, height] : kSizes)
    for (const StudioSettings& settings : settings_to_try())
      for (const BelowView below : {BelowView::Nothing, BelowView::Timeline, BelowView::Results}) {
        const WindowLayout layout = lay_out_window(width, height, settings, below);
        for (const auto& [name, panel] : layout) {
          if (name == "view") continue;
          EXPECT_GT(area(layout.at("view")), area(panel))
              << name << " in " << width << " x " << height << ", list " << settings.list_width
              << ", descriptors " << settings.descriptors_height << ", results "
              << settings.results_height;
        }
      }
}

TEST(WindowLayouts, GiveTheScenarioMoreThanHalfOfTheHeightAtFirst) {
  for (const auto& [width, height] :
       std::vector<std::pair<int, int>>{{1024, 700}, {1280, 800}, {1920, 1080}}) {
    const WindowLayout layout = lay_out_window(width, height, {}, BelowView::Results);
    EXPECT_GT(layout.at("view").height, 0.55 * height);
    EXPECT_GT(layout.at("view").width, 0.6 * width);
  }
}

TEST(WindowLayouts, KeepTheSizesThatTheUserGaveWhereThereIsRoom) {
  const WindowLayout layout =
      lay_out_window(1600, 1000, with_panels(300, 260, 210), BelowView::Results);
  EXPECT_EQ(layout.at("list").width, 300);
  EXPECT_EQ(layout.at("descriptors").height, 260);
  EXPECT_EQ(layout.at("results").height, 210);
  for (const BelowView below : {BelowView::Nothing, BelowView::Timeline}) {
    const WindowLayout without = lay_out_window(1600, 1000, {}, below);
    EXPECT_EQ(without.at("results").height, 0);
    EXPECT_EQ(without.at("timeline").height > 0, below == BelowView::Timeline);
  }
}

}  // namespace
}  // namespace slalom
