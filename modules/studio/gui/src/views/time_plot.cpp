// SPDX-License-Identifier: BSD-3-Clause
#include "views/panels.h"
#include "widgets/drawing.h"

#include <slalom/core/text.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <optional>

namespace slalom {
namespace {

constexpr int kDigits = 3;  ///< decimals of values at the marker
// Of the legend, pixels:
constexpr double kSampleWidth = 14, kSampleGap = 4, kEntryGap = 12;
constexpr float kSmallLegendSize = 11;

constexpr double kDoubleClick = 0.4;  ///< s

/// Lines over the time of a replay. A click moves its time, a drag shows a range of times, and a
/// double click shows all of them. Parts: "plot", "marker".
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
    studio.events().observe({Change::Runs}, [this] { refresh(); });
  }
  std::string text() const override {
    std::string text = y_title_ + " over " + x_title();
    if (!x_range_) return text + "\nno data";
    if (const auto& times = overlay_.shown_times())
      text += "\ntimes " + format_fixed(times->first, 2) + " to " + format_fixed(times->second, 2) +
              " s";
    if (marker()) text += "\nmarker " + format_fixed(*marker(), kDigits);
    for (const LineSeries& series : series_) text += "\n" + legend_of(series);
    return text;
  }

 protected:
  PlotFrame frame() const override {
    const Interval all = x_range_.value_or(Interval(0, 1));
    return PlotFrame::within(area(), overlay_.shown_times().value_or(all), y_range_);
  }
  std::string message() const override { return x_range_ ? "" : "no data"; }
  std::string x_title() const override { return "time (s)"; }
  std::string y_title() const override { return y_title_; }
  void paint_data(NVGcontext* ctx, const PlotFrame& frame) override {
    for (const LineSeries& series : series_) draw_series(ctx, frame, series);
    draw_legend(ctx, frame);
    if (drag_) {
      const auto [left, right] = std::minmax(drag_->first, drag_->second);
      draw::fill(ctx, {left, frame.area.top, right - left, frame.area.height},
                 faded(palette().accent, 0.3));
    }
    if (!marker_visible(frame)) return;
    const double at = frame.x.to_pixel(*marker());
    draw::line(ctx, at, frame.area.top, at, frame.area.bottom(), palette().text, 1.5);
  }
  std::vector<Part> parts() const override {
    std::vector<Part> all = Plot::parts();
    const PlotFrame shown = frame();
    if (marker_visible(shown) && x_range_)
      all.push_back(
          {"marker", {shown.x.to_pixel(*marker()) - 3, shown.area.top, 6, shown.area.height}});
    return all;
  }
  bool press(const Point& at, int /*modifiers*/) override {
    if (x_range_) drag_ = {in_plot(at.x), in_plot(at.x)};
    return true;
  }
  void drag(const Point& at) override {
    if (drag_) drag_->second = in_plot(at.x);
  }
  void release(const Point& /*at*/) override {
    if (!drag_) return;
    const auto [from, to] = *drag_;
    drag_.reset();
    if (std::abs(to - from) < draw::kMinDrag) return click_at(from);
    clicked_.reset();
    const PlotAxis axis = frame().x;
    overlay_.show_times(axis.to_value(from), axis.to_value(to));
  }

 private:
  struct Click {
    double pixel, at;    ///< `at` in s, of the window's clock
    double time_before;  ///< of the replay
  };
  std::string y_title_;
  Values values_;
  ResultsOverlay& overlay_;
  ReplayClock& clock_;
  std::vector<LineSeries> series_;
  std::optional<Interval> x_range_;  ///< nullopt: no data
  Interval y_range_ = {0, 1};
  std::optional<Interval> drag_;  ///< pixels, while the button is pressed
  std::optional<Click> clicked_;  ///< the last click, unless it was the second one

  double in_plot(double pixel) const {
    const ScreenRect plot = frame().area;
    return std::clamp(pixel, plot.left, plot.right());
  }
  /// Moves the time; a second click undoes that and shows all times.
  void click_at(double pixel) {
    const double now = glfwGetTime();
    if (clicked_ && now - clicked_->at < kDoubleClick &&
        std::abs(pixel - clicked_->pixel) < draw::kMinDrag) {
      clock_.seek(clicked_->time_before);
      clicked_.reset();
      return overlay_.show_all_times();
    }
    clicked_ = Click{pixel, now, clock_.time()};
    const PlotAxis axis = frame().x;
    clock_.seek(std::clamp(axis.to_value(pixel), axis.low(), axis.high()));
  }
  bool marker_visible(const PlotFrame& frame) const {
    return marker() && *marker() >= frame.x.low() && *marker() <= frame.x.high();
  }

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
  /// The series beside the title. Entries are drawn completely: smaller or without their values
  /// where there is little space, and the rest as a number, "+3".
  void draw_legend(NVGcontext* ctx, const PlotFrame& frame) const {
    const double title = draw::text_width(ctx, y_title_, draw::kSmallTextSize);
    const double left = frame.area.left + title, space = frame.area.right() - left;
    for (const bool values : {true, false})
      for (const float size : {draw::kSmallTextSize, kSmallLegendSize}) {
        double wide = 0;
        for (const LineSeries& series : series_)
          wide += entry_width(ctx, values ? legend_of(series) : series.name, size);
        if (wide - kEntryGap <= space) return draw_entries(ctx, frame, left, values, size);
      }
    draw_entries(ctx, frame, left, false, kSmallLegendSize);
  }
  static double entry_width(NVGcontext* ctx, const std::string& entry, float size) {
    return kSampleWidth + kSampleGap + draw::text_width(ctx, entry, size) + 1 + kEntryGap;
  }
  void draw_entries(NVGcontext* ctx, const PlotFrame& frame, double left, bool values,
                    float size) const {
    const double right = frame.area.right(), top = frame.area.top;
    const double more = draw::text_width(ctx, "+" + std::to_string(series_.size()), size) + 1;
    for (std::size_t i = 0; i < series_.size(); ++i) {
      const std::string entry = values ? legend_of(series_[i]) : series_[i].name;
      const double wide = entry_width(ctx, entry, size);
      const double needed = wide - kEntryGap + (i + 1 < series_.size() && !values ? more : 0);
      if (left + needed > right && !values && size == kSmallLegendSize)
        return draw::text(ctx, {right - more, top - 19, more, 18},
                          "+" + std::to_string(series_.size() - i), palette().faint_text, size,
                          draw::Align::Right);
      draw::line(ctx, left, top - 10, left + kSampleWidth, top - 10, series_[i].color, 3);
      const double text = left + kSampleWidth + kSampleGap;
      draw::text(ctx, {text, top - 19, wide, 18}, entry, palette().text, size);
      left += wide;
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
