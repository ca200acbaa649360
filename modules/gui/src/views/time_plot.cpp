#include "views/panels.h"
#include "widgets/drawing.h"

#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace slalom {
namespace {

constexpr int kDigits = 3;  ///< decimals of values at the marker

/// Lines over the time of a replay, whose time is moved by clicking and dragging. Parts: "plot",
/// "marker".
class TimePlot : public Plot {
 public:
  using Values = std::vector<double> OverlayRun::*;
  TimePlot(nanogui::Widget* parent, Studio& studio, const std::string& id, std::string y_title,
           Values values)
      : Plot(parent, id),
        y_title_(std::move(y_title)),
        values_(values),
        overlay_(studio.results().overlay()),
        clock_(overlay_.clock()) {
    studio.notices().observe({Change::Runs}, [this] { refresh(); });
  }
  std::string text() const override {
    std::string text = y_title_ + " over " + x_title();
    if (!x_range_) return text + "\nno data";
    if (marker()) text += "\nmarker " + format_fixed(*marker(), kDigits);
    for (const LineSeries& series : series_) text += "\n" + legend_of(series);
    return text;
  }

 protected:
  PlotFrame frame() const override {
    return PlotFrame::within(area(), x_range_.value_or(std::pair(0.0, 1.0)), y_range_);
  }
  std::string message() const override { return x_range_ ? "" : "no data"; }
  std::string x_title() const override { return "time (s)"; }
  std::string y_title() const override { return y_title_; }
  void paint_data(NVGcontext* ctx, const PlotFrame& frame) override {
    for (const LineSeries& series : series_) draw_series(ctx, frame, series);
    draw_legend(ctx, frame);
    if (!marker() || *marker() > frame.x.high()) return;
    const double at = frame.x.to_pixel(*marker());
    draw::line(ctx, at, frame.area.top, at, frame.area.bottom(), palette().text, 1.5);
  }
  std::vector<Part> parts() const override {
    std::vector<Part> all = Plot::parts();
    const PlotFrame shown = frame();
    if (marker() && x_range_)
      all.push_back(
          {"marker", {shown.x.to_pixel(*marker()) - 3, shown.area.top, 6, shown.area.height}});
    return all;
  }
  bool press(const Point& at, int /*modifiers*/) override {
    const PlotAxis axis = frame().x;
    if (x_range_) clock_.seek(std::clamp(axis.to_value(at.x), axis.low(), axis.high()));
    return true;
  }
  void drag(const Point& at) override { press(at, 0); }

 private:
  std::string y_title_;
  Values values_;
  ResultsOverlay& overlay_;
  ReplayClock& clock_;
  std::vector<LineSeries> series_;
  std::optional<Interval> x_range_;  ///< nullopt: no data
  Interval y_range_ = {0, 1};

  void refresh() {
    series_.clear();
    for (std::size_t i = 0; i < overlay_.runs().size(); ++i) {
      const OverlayRun& run = overlay_.runs()[i];
      if (run.trajectory && overlay_.is_shown(i))
        series_.push_back(
            {overlay_label(run.record), overlay_.color_of(i), run.times, run.*values_});
    }
    x_range_.reset();
    std::optional<Interval> y = Interval(0, 0);
    for (const LineSeries& line : series_) {
      for (const double x : line.x) widen(x_range_, x);
      for (const double value : line.y)
        if (std::isfinite(value)) widen(y, value);
    }
    const double margin = 0.05 * (y->second - y->first);
    y_range_ = {y->first < 0 ? y->first - margin : 0, y->second > 0 ? y->second + margin : 0};
    if (margin == 0) y_range_ = {0, 1};
  }
  std::optional<double> marker() const {
    return clock_.duration() > 0 ? std::optional(clock_.time()) : std::nullopt;
  }
  void draw_series(NVGcontext* ctx, const PlotFrame& frame, const LineSeries& series) const {
    nvgSave(ctx);
    draw::clip(ctx, frame.area);
    nvgBeginPath(ctx);
    bool joined = false;
    for (const std::size_t i :
         downsampled(series, frame.x.low(), frame.x.high(), static_cast<int>(frame.area.width))) {
      const auto x = static_cast<float>(frame.x.to_pixel(series.x[i]));
      const auto y = static_cast<float>(frame.y.to_pixel(series.y[i]));
      const bool gap = std::isnan(series.y[i]);
      if (!gap) (joined ? nvgLineTo : nvgMoveTo)(ctx, x, y);
      joined = !gap;
    }
    draw::stroke_path(ctx, series.color, 2);
    nvgRestore(ctx);
  }
  void draw_legend(NVGcontext* ctx, const PlotFrame& frame) const {
    constexpr double kSample = 14, kGap = 12;
    const double right = frame.area.right(), top = frame.area.top;
    double left = frame.area.left + draw::text_width(ctx, y_title_, draw::kSmallTextSize);
    for (const LineSeries& series : series_) {
      const std::string legend = legend_of(series);
      const double wide = draw::text_width(ctx, legend, draw::kSmallTextSize) + 1;
      if (left + kSample + 4 + 20 > right) return;
      draw::line(ctx, left, top - 10, left + kSample, top - 10, series.color, 3);
      left += kSample + 4;
      draw::text(ctx, {left, top - 19, std::min(wide, right - left), 18}, legend, palette().text,
                 draw::kSmallTextSize);
      left += wide + kGap;
    }
  }
  std::string legend_of(const LineSeries& series) const {
    const auto value = marker() ? series.value_at(*marker()) : std::nullopt;
    return value ? series.name + " " + format_fixed(*value, kDigits) : series.name;
  }
};

}  // namespace

Element* make_time_plot(nanogui::Widget* parent, Studio& studio, const std::string& id,
                        const std::string& y_title, std::vector<double> OverlayRun::*values) {
  return new TimePlot(parent, studio, id, y_title, values);
}

}  // namespace slalom
