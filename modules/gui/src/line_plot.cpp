#include <slalom/core/text.h>
#include <slalom/gui/drawing.h>
#include <slalom/gui/line_plot.h>
#include <slalom/gui/palette.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using Range = std::pair<double, double>;

constexpr int kDigits = 3;  ///< of values that are read off at the marker

void widen(std::optional<Range>& range, const std::optional<Range>& by) {
  if (!by) return;
  if (!range) range = by;
  range->first = std::min(range->first, by->first);
  range->second = std::max(range->second, by->second);
}

}  // namespace

LinePlot::LinePlot(nanogui::Widget* parent, const std::string& id, std::string x_title,
                   std::string y_title)
    : Element(parent, id), x_title_(std::move(x_title)), y_title_(std::move(y_title)) {}

void LinePlot::set_series(std::vector<LineSeries> series) {
  series_ = std::move(series);
  measure();
}

void LinePlot::set_marker(std::optional<double> x) {
  marker_ = x;
}

void LinePlot::set_x_range(std::optional<Range> range) {
  given_x_range_ = range;
  measure();
}

void LinePlot::measure() {
  std::optional<Range> x = given_x_range_, y;
  for (const LineSeries& series : series_) {
    if (!given_x_range_) widen(x, range_of(series.x));
    widen(y, range_of(series.y));
  }
  x_range_ = x;
  y_range_ = y ? Range{std::min(0.0, y->first), std::max(0.0, y->second)} : Range{0, 1};
  const double room = 0.05 * (y_range_.second - y_range_.first);
  if (y_range_.second > 0) y_range_.second += room;
  if (y_range_.first < 0) y_range_.first -= room;
}

PlotFrame LinePlot::frame() const {
  return PlotFrame::within(*Element::rect_of(""), x_range_.value_or(Range{0, 1}), y_range_);
}

std::string LinePlot::legend_of(const LineSeries& series) const {
  const auto value = marker_ ? series.value_at(*marker_) : std::nullopt;
  return value ? series.name + " " + format_fixed(*value, kDigits) : series.name;
}

std::string LinePlot::text() const {
  std::string text = y_title_ + " over " + x_title_;
  if (!x_range_) return text + "\nno data";
  if (marker_) text += "\nmarker " + format_fixed(*marker_, kDigits);
  for (const LineSeries& series : series_) text += "\n" + legend_of(series);
  return text;
}

std::optional<ScreenRect> LinePlot::rect_of(const std::string& part) const {
  const PlotFrame shown = frame();
  if (part == "plot") return shown.area;
  if (part != "marker") return Element::rect_of(part);
  if (!marker_ || !x_range_) return std::nullopt;
  return ScreenRect{shown.x.to_pixel(*marker_) - 3, shown.area.top, 6, shown.area.height};
}

void LinePlot::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  draw::fill(ctx, *Element::rect_of(""), palette().panel);
  const PlotFrame shown = frame();
  if (!x_range_) {
    draw::frame(ctx, shown.area, palette().border);
    draw::text(ctx, shown.area, "no data", palette().faint_text, draw::kTextSize,
               draw::Align::Center);
  } else {
    shown.draw(ctx, x_title_, y_title_);
    for (const LineSeries& series : series_) draw_series(ctx, shown, series);
    draw_marker(ctx, shown);
    draw_legend(ctx, shown);
  }
  nvgRestore(ctx);
}

void LinePlot::draw_series(NVGcontext* ctx, const PlotFrame& frame,
                           const LineSeries& series) const {
  nvgSave(ctx);
  nvgIntersectScissor(ctx, static_cast<float>(frame.area.left), static_cast<float>(frame.area.top),
                      static_cast<float>(frame.area.width), static_cast<float>(frame.area.height));
  nvgBeginPath(ctx);
  bool joined = false;
  for (const std::size_t i :
       thinned(series, frame.x.low(), frame.x.high(), static_cast<int>(frame.area.width))) {
    const auto x = static_cast<float>(frame.x.to_pixel(series.x[i]));
    const auto y = static_cast<float>(frame.y.to_pixel(series.y[i]));
    const bool gap = std::isnan(series.y[i]);
    if (!gap && joined) nvgLineTo(ctx, x, y);
    if (!gap && !joined) nvgMoveTo(ctx, x, y);
    joined = !gap;
  }
  nvgStrokeColor(ctx, series.color);
  nvgStrokeWidth(ctx, 2);
  nvgStroke(ctx);
  nvgRestore(ctx);
}

void LinePlot::draw_marker(NVGcontext* ctx, const PlotFrame& frame) const {
  if (!marker_ || *marker_ < frame.x.low() || *marker_ > frame.x.high()) return;
  const double at = frame.x.to_pixel(*marker_);
  draw::line(ctx, at, frame.area.top, at, frame.area.top + frame.area.height, palette().text, 1.5);
}

void LinePlot::draw_legend(NVGcontext* ctx, const PlotFrame& frame) const {
  constexpr double kSwatch = 14, kGap = 12;
  const double right = frame.area.left + frame.area.width;
  double left = frame.area.left + draw::text_width(ctx, y_title_, draw::kSmallTextSize);
  for (const LineSeries& series : series_) {
    const std::string legend = legend_of(series);
    const double wide = draw::text_width(ctx, legend, draw::kSmallTextSize) + 1;
    if (left + kSwatch + 4 + 20 > right) return;
    const double room = std::min(wide, right - left - kSwatch - 4);
    draw::line(ctx, left, frame.area.top - 10, left + kSwatch, frame.area.top - 10, series.color,
               3);
    draw::text(ctx, {left + kSwatch + 4, frame.area.top - 19, room, 18}, legend, palette().text,
               draw::kSmallTextSize);
    left += kSwatch + 4 + wide + kGap;
  }
}

void LinePlot::seek(const nanogui::Vector2i& p) const {
  if (!on_seek || !x_range_) return;
  const PlotAxis axis = frame().x;
  on_seek(std::clamp(axis.to_value(p.x() - mPos.x()), axis.low(), axis.high()));
}

bool LinePlot::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down,
                                int /*modifiers*/) {
  if (button == GLFW_MOUSE_BUTTON_LEFT && down) seek(p);
  return true;
}

bool LinePlot::mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& /*rel*/,
                              int /*button*/, int /*modifiers*/) {
  seek(p);
  return true;
}

}  // namespace slalom
