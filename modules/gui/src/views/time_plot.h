#pragma once

#include "widgets/plot.h"

#include <slalom/studio/plot_data.h>
#include <slalom/studio/replay_clock.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Lines over the time of a replay, whose time is moved by clicking and dragging. Parts: "plot",
/// "marker".
class TimePlot : public Plot {
 public:
  /// The title includes the unit: "speed (m/s)".
  TimePlot(nanogui::Widget* parent, const std::string& id, std::string y_title, ReplayClock& clock)
      : Plot(parent, id), y_title_(std::move(y_title)), clock_(clock) {}
  void set_series(std::vector<LineSeries> series);
  std::string text() const override;

 protected:
  PlotFrame frame() const override;
  std::string message() const override { return x_range_ ? "" : "no data"; }
  std::string x_title() const override { return "time (s)"; }
  std::string y_title() const override { return y_title_; }
  void paint_data(NVGcontext* ctx, const PlotFrame& frame) override;
  std::vector<Part> parts() const override;
  bool press(const Point& at, int modifiers) override;
  void drag(const Point& at) override { press(at, 0); }

 private:
  std::string y_title_;
  ReplayClock& clock_;
  std::vector<LineSeries> series_;
  std::optional<Interval> x_range_;  ///< nullopt: no data
  Interval y_range_ = {0, 1};

  std::optional<double> marker() const;
  void draw_series(NVGcontext* ctx, const PlotFrame& frame, const LineSeries& series) const;
  void draw_legend(NVGcontext* ctx, const PlotFrame& frame) const;
  std::string legend_of(const LineSeries& series) const;
};

}  // namespace slalom
