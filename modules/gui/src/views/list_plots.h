#pragma once

#include "widgets/plot.h"

#include <slalom/studio/plot_data.h>
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

/// A scatter plot of the active list over two descriptors, the current scenario marked. Dragging
/// selects the scenarios in a rectangle, a click makes the scenario under the mouse current. Parts:
/// "plot", "current", "selection".
class ScatterPlot : public Plot {
 public:
  ScatterPlot(nanogui::Widget* parent, Studio& studio) : Plot(parent, "scatter"), studio_(studio) {}
  /// After a change of the values or of the axes.
  void update(const QuantityInfo& x, const QuantityInfo& y);
  std::string text() const override;

 protected:
  PlotFrame frame() const override;
  std::string message() const override;
  std::string x_title() const override { return with_unit(x_info_.name, x_info_.unit); }
  std::string y_title() const override { return with_unit(y_info_.name, y_info_.unit); }
  std::string remark() const override;
  void paint_data(NVGcontext* ctx, const PlotFrame& frame) override;
  std::vector<Part> parts() const override;
  bool press(const Point& at, int modifiers) override;
  void drag(const Point& at) override;
  void release(const Point& at) override;

 private:
  /// Two opposite corners, as values of the axes.
  struct Drag {
    Point from, to;
    bool moved = false;
  };
  Studio& studio_;
  std::shared_ptr<const ListValues> values_;
  Scatter scatter_;
  QuantityInfo x_info_, y_info_;
  std::optional<Drag> drag_;       ///< while the button is down
  std::optional<Drag> selection_;  ///< the last rectangle
  std::size_t selected_count_ = 0;
  int image_ = 0;                           ///< NanoVG's handle; 0 for none
  int image_width_ = 0, image_height_ = 0;  ///< pixels
  bool image_outdated_ = true;

  Point value_at(const Point& at) const;
  std::optional<Point> current_point() const;
  ScreenRect rect_between(const PlotFrame& frame, const Drag& drag) const;
  void update_image(NVGcontext* ctx, const PlotFrame& frame);
  void draw_marks(NVGcontext* ctx, const PlotFrame& frame) const;
};

}  // namespace slalom
