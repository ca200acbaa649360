#pragma once

#include <slalom/gui/line_plot.h>
#include <slalom/gui/replay_bar.h>
#include <slalom/gui/results_overlay.h>
#include <slalom/gui/run_table.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// The results overlay: its runs as a table, the replay with its slider, and clearance and speed
/// over time. Wide panels have the table at the left, high ones above. Keys: those of RunTable,
/// unless the slider has the focus, then those of ReplayBar.
///
/// Parts: those of RunTable and ReplayBar; its elements have the ids "runs", "replay",
/// "plot_clearance" and "plot_speed".
class ResultsPanel : public Element {
 public:
  explicit ResultsPanel(nanogui::Widget* parent);

  /// What is drawn over the scenario has changed: another run, another time.
  std::function<void(std::vector<OverlayTrajectory>)> on_overlay_changed;

  void set_source(OverlaySource source);
  void set_runs(std::vector<OverlayRun> runs);
  void set_message(const std::string& message);  ///< why there are no runs
  const ResultsOverlay& overlay() const { return overlay_; }
  ReplayBar& replay() { return *replay_; }  ///< for keys from outside

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void performLayout(NVGcontext* ctx) override;
  void draw(NVGcontext* ctx) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 private:
  void runs_changed();
  void time_changed();
  void fill_plots();
  void lay_out_plots(int left, int top, int wide, int tall);
  void tell_overlay() const;

  ResultsOverlay overlay_;
  RunTable* table_;
  ReplayBar* replay_;
  LinePlot* clearance_;
  LinePlot* speed_;
  nanogui::Vector2i laid_out_ = {0, 0};  ///< the size for which its elements lie as they do
};

}  // namespace slalom
