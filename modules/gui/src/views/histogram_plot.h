#pragma once

#include "widgets/plot.h"

#include <slalom/studio/histogram.h>
#include <slalom/studio/studio.h>

#include <optional>
#include <string>

namespace slalom {

/// A histogram of the active list with the current scenario marked. A click on a bar filters the
/// list by its range. Parts: "plot", "bin 0", "bin 1", ..., "current".
class HistogramPlot : public Plot {
 public:
  HistogramPlot(nanogui::Widget* parent, Studio& studio)
      : Plot(parent, "histogram"), studio_(studio) {}
  void update();  ///< after a change of the values or of the selected descriptor
  std::string text() const override;

 protected:
  PlotFrame frame() const override;
  std::string message() const override;
  std::string x_title() const override { return with_unit(info().name, info().unit); }
  std::string y_title() const override { return "scenarios"; }
  std::string remark() const override;
  void paint_data(NVGcontext* ctx, const PlotFrame& frame) override;
  std::vector<Part> parts() const override;
  bool press(const Point& at, int modifiers) override;
  void hover(const std::optional<Point>& at) override;

 private:
  Studio& studio_;
  Histogram histogram_;
  std::optional<double> current_;
  std::optional<std::size_t> hovered_;

  const QuantityInfo& info() const { return studio_.descriptors().model().selected_row().info; }
  ScreenRect bar_rect(const PlotFrame& frame, std::size_t bar, bool full) const;
  std::optional<std::size_t> bar_at(const Point& at) const;
  std::string bar_text(std::size_t bar) const;
};

}  // namespace slalom
