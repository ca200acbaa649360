#pragma once

#include <slalom/gui/line_series.h>
#include <slalom/gui/plot_frame.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Lines over one axis, with a marker that is moved by clicking and dragging. Parts: "plot" (the
/// area between the axes), "marker".
class LinePlot : public Element {
 public:
  /// Titles name their unit, e.g. "time (s)".
  LinePlot(nanogui::Widget* parent, const std::string& id, std::string x_title,
           std::string y_title);

  void set_series(std::vector<LineSeries> series);
  void set_marker(std::optional<double> x);
  const std::optional<double>& marker() const { return marker_; }
  /// The range of x; nullopt for that of the series.
  void set_x_range(std::optional<std::pair<double, double>> range);

  std::function<void(double x)> on_seek;

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                      int modifiers) override;

 private:
  std::string x_title_, y_title_;
  std::vector<LineSeries> series_;
  std::optional<double> marker_;
  std::optional<std::pair<double, double>> given_x_range_;
  std::optional<std::pair<double, double>> x_range_;  ///< nullopt: nothing to show
  std::pair<double, double> y_range_ = {0, 1};

  PlotFrame frame() const;
  void measure();
  void seek(const nanogui::Vector2i& p) const;
  void draw_series(NVGcontext* ctx, const PlotFrame& frame, const LineSeries& series) const;
  void draw_legend(NVGcontext* ctx, const PlotFrame& frame) const;
  void draw_marker(NVGcontext* ctx, const PlotFrame& frame) const;
  std::string legend_of(const LineSeries& series) const;
};

}  // namespace slalom
