#pragma once

#include "views/replay_bar.h"
#include "views/run_table.h"
#include "views/time_plot.h"

#include <slalom/studio/studio.h>

#include <string>

namespace slalom {

/// The recorded runs: their table, the replay with its slider, and plots of clearance and speed
/// over time. Wide panels have the table at the left, high ones at the top. Keys: those of
/// RunTable, or those of ReplayBar if the slider has the focus.
///
/// Parts: those of RunTable and ReplayBar; its elements have the ids "runs", "replay",
/// "plot_clearance" and "plot_speed".
class ResultsPanel : public Element {
 public:
  ResultsPanel(nanogui::Widget* parent, Studio& studio);
  ReplayBar& replay() { return *replay_; }  ///< for keys of the window
  std::string text() const override;
  void performLayout(NVGcontext* ctx) override;
  void draw(NVGcontext* ctx) override;

 protected:
  void paint(NVGcontext* ctx) override;
  bool key(int key, int modifiers) override;

 private:
  ResultsOverlay& overlay_;
  RunTable* table_;
  ReplayBar* replay_;
  TimePlot* clearance_;
  TimePlot* speed_;
  nanogui::Vector2i laid_out_size_ = {0, 0};  ///< the size of the current layout

  void refresh();
  void lay_out_plots(const ScreenRect& rect);
};

}  // namespace slalom
