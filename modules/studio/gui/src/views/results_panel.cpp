// SPDX-License-Identifier: BSD-3-Clause
#include "views/panels.h"
#include "widgets/drawing.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace slalom {
namespace {

constexpr double kTitleHeight = 26, kReplayHeight = 34, kSplitterGap = 4, kPlotHeight = 110;
constexpr double kWide = 700, kWideIfLow = 600, kTableWidth = 520, kMinTableWidth = 300;

std::string title_of(const OverlaySource& source) {
  if (source.path.empty()) return "Results";
  std::string title = source.here
                          ? "Run here"
                          : "Results: " + std::filesystem::path(source.path).filename().string();
  if (!source.campaign.empty()) title += ", campaign " + source.campaign;
  return title;
}

std::string value_text(const std::optional<double>& value, const char* unit) {
  if (!value) return "NA (the run has ended)";
  char number[48];
  std::snprintf(number, sizeof number, "%.2f %s", *value, unit);
  return number;
}

/// The recorded runs: their table, the replay with its slider, and plots of clearance and speed
/// over time. Wide panels have the table at the left, high ones at the top. Keys: those of
/// the table, or those of the replay if the slider has the focus; 0 shows all times in the plots.
///
/// Parts: those of the table and of the replay; its elements have the ids "runs", "replay",
/// "plot_clearance" and "plot_speed".
class ResultsPanel : public Element {
 public:
  ResultsPanel(nanogui::Widget* parent, Studio& studio)
      : Element(parent, "results", Focus::OnPress),
        overlay_(studio.results().overlay()),
        table_(make_run_table(this, studio)),
        replay_(make_replay_bar(this, overlay_.clock(), "replay")),
        clearance_(make_time_plot(this, studio, "plot_clearance", "clearance (m)",
                                  &OverlayRun::clearances)),
        speed_(make_time_plot(this, studio, "plot_speed", "speed (m/s)", &OverlayRun::speeds)) {}
  std::string text() const override {
    std::string text = title_of(overlay_.source());
    for (std::size_t run = 0; run < overlay_.runs().size(); ++run)
      if (overlay_.is_shown(run) && overlay_.runs()[run].trajectory)
        text += "\nnow " + overlay_label(overlay_.runs()[run].record) + ": clearance " +
                value_text(overlay_.clearance_now(run), "m") + ", speed " +
                value_text(overlay_.speed_now(run), "m/s");
    return text;
  }
  void performLayout(NVGcontext* ctx) override {
    const double wide = width(), tall = height() - kTitleHeight;
    if (wide > height() && (wide >= kWide || (wide >= kWideIfLow && wide > 2 * height()))) {
      const double left = std::clamp(0.4 * wide, std::min(kMinTableWidth, wide / 2), kTableWidth);
      const double right = left + kSplitterGap;
      table_->set_bounds({0, kTitleHeight, left, tall});
      replay_->set_bounds({right, kTitleHeight, wide - right, kReplayHeight});
      lay_out_plots({right, kTitleHeight + kReplayHeight, wide - right, tall - kReplayHeight});
    } else {
      const double table = 0.4 * tall, below = kTitleHeight + table + kReplayHeight;
      table_->set_bounds({0, kTitleHeight, wide, table});
      replay_->set_bounds({0, kTitleHeight + table, wide, kReplayHeight});
      lay_out_plots({0, below, wide, height() - below});
    }
    laid_out_size_ = size();
    Widget::performLayout(ctx);
  }
  void draw(NVGcontext* ctx) override {
    if (size() != laid_out_size_) performLayout(ctx);
    Element::draw(ctx);
  }

 protected:
  void paint(NVGcontext* ctx) override {
    draw::fill(ctx, area(), palette().panel);
    draw::text(ctx, {6, 0, width() - 12.0, kTitleHeight}, title_of(overlay_.source()),
               palette().text, draw::kTextSize, draw::Align::Left, true);
  }
  bool key(int key, int modifiers) override {
    // nanogui sends keys to outer elements first; they go to the table unless the slider has focus.
    if (key == GLFW_KEY_0) return overlay_.show_all_times(), true;
    if (!replay_->focused() && table_->keyboardEvent(key, 0, GLFW_PRESS, modifiers)) return true;
    return replay_->keyboardEvent(key, 0, GLFW_PRESS, modifiers);
  }

 private:
  ResultsOverlay& overlay_;
  Element *table_, *replay_, *clearance_, *speed_;
  nanogui::Vector2i laid_out_size_ = {0, 0};  ///< the size of the current layout

  /// Stacked if the panel is high enough, otherwise side by side.
  void lay_out_plots(const ScreenRect& rect) {
    ScreenRect first = rect, second = rect;
    if (rect.height >= 2 * kPlotHeight || rect.width < 2 * kPlotHeight) {
      first.height = second.height = 0.5 * rect.height;
      second.top = first.bottom();
    } else {
      first.width = second.width = 0.5 * rect.width;
      second.left = first.right();
    }
    clearance_->set_bounds(first);
    speed_->set_bounds(second);
  }
};

}  // namespace

Element* make_results_panel(nanogui::Widget* parent, Studio& studio) {
  return new ResultsPanel(parent, studio);
}

}  // namespace slalom
