// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/splitter.h"
#include "window/window_layout.h"

#include <algorithm>

namespace slalom {
namespace {

constexpr int kMenuHeight = 28, kStatusHeight = 28, kTimelineHeight = 34;
constexpr int kMinPanel = 120;  // pixels, so that no panel can be dragged out of sight
// With at least (1 - 0.4)^2 = 0.36 of the area between menu and status bar the view is larger than
// the list, which has at most 0.4 (1 - 0.2) = 0.32, and than all other elements.
constexpr double kMaxListWidth = 0.4, kMaxResultsHeight = 0.4;              // of that area
constexpr double kMinDescriptorsHeight = 0.2, kMaxDescriptorsHeight = 0.5;  // of that area

int fraction(double of, int pixels) {
  return static_cast<int>(of * pixels);
}

ScreenRect rect(int left, int top, int width, int height) {
  return {static_cast<double>(left), static_cast<double>(top),
          static_cast<double>(std::max(width, 0)), static_cast<double>(std::max(height, 0))};
}

int content_height(int height) {
  return height - kMenuHeight - kStatusHeight;
}

int fitted(int size, int min_size, int max_size) {
  return std::clamp(size, std::min(min_size, max_size), max_size);
}

}  // namespace

StudioSettings with_fitted_panels(StudioSettings settings, int width, int height) {
  const int content = std::max(content_height(height), 0);
  settings.list_width = fitted(settings.list_width, kMinPanel, fraction(kMaxListWidth, width));
  settings.descriptors_height = fitted(
      settings.descriptors_height, std::max(kMinPanel, fraction(kMinDescriptorsHeight, content)),
      fraction(kMaxDescriptorsHeight, content));
  settings.results_height =
      fitted(settings.results_height, kMinPanel, fraction(kMaxResultsHeight, content));
  return settings;
}

WindowLayout lay_out_window(int width, int height, const StudioSettings& settings,
                            BelowView below_view) {
  const StudioSettings sizes = with_fitted_panels(settings, width, height);
  const int bar = Splitter::kThickness;
  const int top = kMenuHeight, tall = content_height(height), bottom = top + tall;
  const int list = sizes.list_width, left = list + bar, right = width - left;
  const bool results = below_view == BelowView::Results;
  const int lower = sizes.descriptors_height, below = results ? sizes.results_height : 0;
  const int timeline = below_view == BelowView::Timeline ? kTimelineHeight : 0;
  return {{"menu", rect(0, 0, width, kMenuHeight)},
          {"list", rect(0, top, list, tall - lower - bar)},
          {"splitter_descriptors", rect(0, bottom - lower - bar, list, bar)},
          {"descriptors", rect(0, bottom - lower, list, lower)},
          {"splitter_list", rect(list, top, bar, tall)},
          {"view", rect(left, top, right, tall - timeline - (results ? below + bar : 0))},
          {"timeline", rect(left, bottom - timeline, right, timeline)},
          {"splitter_results", rect(left, bottom - below - bar, right, results ? bar : 0)},
          {"results", rect(left, bottom - below, right, below)},
          {"status", rect(0, bottom, width, kStatusHeight)}};
}

}  // namespace slalom
