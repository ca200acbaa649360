#include <slalom/gui/descriptor_model.h>
#include <slalom/gui/drawing.h>
#include <slalom/gui/histogram_plot.h>
#include <slalom/gui/palette.h>

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {

HistogramPlot::HistogramPlot(nanogui::Widget* parent) : Element(parent, "histogram") {}

void HistogramPlot::set_histogram(const QuantityInfo& info, Histogram histogram,
                                  std::string message) {
  info_ = info;
  histogram_ = std::move(histogram);
  message_ = std::move(message);
  hovered_.reset();
}

void HistogramPlot::set_current(std::optional<double> value) {
  current_ = value;
}

PlotFrame HistogramPlot::frame() const {
  std::pair<double, double> range = {0, 1};
  if (!histogram_.bars.empty()) range = {histogram_.bars.front().low, histogram_.bars.back().high};
  const auto most = static_cast<double>(std::max<std::size_t>(histogram_.largest_count(), 1));
  PlotFrame frame = PlotFrame::within(*Element::rect_of(""), range, {0, 1.08 * most});
  frame.whole_y = true;
  return frame;
}

ScreenRect HistogramPlot::bar_rect(const PlotFrame& frame, std::size_t bar, bool full) const {
  const Histogram::Bar& what = histogram_.bars[bar];
  const double left = frame.x.to_pixel(what.low), right = frame.x.to_pixel(what.high);
  const double bottom = frame.area.top + frame.area.height;
  const double top = full ? frame.area.top : frame.y.to_pixel(static_cast<double>(what.count));
  return {left, top, right - left, bottom - top};
}

std::optional<std::size_t> HistogramPlot::bar_below(const nanogui::Vector2i& p) const {
  const PlotFrame shown = frame();
  const double x = p.x() - mPos.x(), y = p.y() - mPos.y();
  if (!shown.area.contains(x, y)) return std::nullopt;
  return histogram_.bar_of(shown.x.to_value(x));
}

std::string HistogramPlot::bar_text(std::size_t bar) const {
  const Histogram::Bar& what = histogram_.bars[bar];
  const std::string unit = info_.unit == "-" ? "" : " " + info_.unit;
  return what.label + unit + ": " + std::to_string(what.count);
}

std::string HistogramPlot::without_number() const {
  std::string text;
  if (histogram_.na > 0) text = std::to_string(histogram_.na) + " NA";
  if (histogram_.not_computed > 0)
    text += (text.empty() ? "" : ", ") + std::to_string(histogram_.not_computed) + " not computed";
  return text;
}

std::string HistogramPlot::text() const {
  std::string text = "histogram of " + with_unit(info_.name, info_.unit);
  if (histogram_.bars.empty()) text += "\n" + message_;
  for (std::size_t bar = 0; bar < histogram_.bars.size(); ++bar) {
    const bool here = current_ && histogram_.bar_of(*current_) == bar;
    text += "\n" + bar_text(bar) + (here ? " <- current " + descriptor_number(*current_) : "");
  }
  const std::string others = without_number();
  if (!others.empty()) text += "\n" + others;
  if (hovered_) text += "\nunder the mouse: " + bar_text(*hovered_);
  return text;
}

std::optional<ScreenRect> HistogramPlot::rect_of(const std::string& part) const {
  const PlotFrame shown = frame();
  if (part == "plot") return shown.area;
  for (std::size_t bar = 0; bar < histogram_.bars.size(); ++bar) {
    if (part == "bin " + std::to_string(bar)) return bar_rect(shown, bar, true);
    if (part == "current" && current_ && histogram_.bar_of(*current_) == bar)
      return bar_rect(shown, bar, true);
  }
  return Element::rect_of(part);
}

void HistogramPlot::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  draw::fill(ctx, *Element::rect_of(""), palette().panel);
  const PlotFrame shown = frame();
  if (histogram_.bars.empty()) {
    draw::text(ctx, *Element::rect_of(""), message_, palette().faint_text, draw::kTextSize,
               draw::Align::Center);
  } else {
    shown.draw(ctx, with_unit(info_.name, info_.unit), "scenarios");
    draw_bars(ctx, shown);
    draw_current(ctx, shown);
  }
  const double right = shown.area.left + shown.area.width;
  const ScreenRect strip{right - 0.75 * width(), 1, 0.75 * width(), shown.area.top - 2};
  draw::text(ctx, strip, hovered_ ? bar_text(*hovered_) : without_number(),
             hovered_ ? palette().text : palette().faint_text, draw::kSmallTextSize,
             draw::Align::Right);
  nvgRestore(ctx);
}

void HistogramPlot::draw_bars(NVGcontext* ctx, const PlotFrame& frame) const {
  for (std::size_t bar = 0; bar < histogram_.bars.size(); ++bar) {
    if (hovered_ == bar) draw::fill(ctx, bar_rect(frame, bar, true), palette().hover);
    if (histogram_.bars[bar].count == 0) continue;
    ScreenRect rect = bar_rect(frame, bar, false);
    const double gap = rect.width > 6 ? 1 : 0;
    rect = {rect.left + gap, std::min(rect.top, rect.top + rect.height - 1), rect.width - 2 * gap,
            std::max(rect.height, 1.0)};
    draw::fill(ctx, rect, hovered_ == bar ? palette().text : palette().accent);
  }
}

void HistogramPlot::draw_current(NVGcontext* ctx, const PlotFrame& frame) const {
  if (!current_ || !histogram_.bar_of(*current_)) return;
  const double at = frame.x.to_pixel(*current_), top = frame.area.top;
  draw::line(ctx, at, top, at, top + frame.area.height, plot_mark_color(), 2);
  nvgBeginPath(ctx);
  nvgMoveTo(ctx, static_cast<float>(at - 5), static_cast<float>(top));
  nvgLineTo(ctx, static_cast<float>(at + 5), static_cast<float>(top));
  nvgLineTo(ctx, static_cast<float>(at), static_cast<float>(top + 8));
  nvgClosePath(ctx);
  nvgFillColor(ctx, plot_mark_color());
  nvgFill(ctx);
}

bool HistogramPlot::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down,
                                     int /*modifiers*/) {
  if (button != GLFW_MOUSE_BUTTON_LEFT) return false;
  const auto bar = bar_below(p);
  if (down && bar && on_choose) on_choose(histogram_.bars[*bar].low, histogram_.bars[*bar].high);
  return true;
}

bool HistogramPlot::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& /*rel*/,
                                     int /*button*/, int /*modifiers*/) {
  hovered_ = bar_below(p);
  return true;
}

bool HistogramPlot::mouseEnterEvent(const nanogui::Vector2i& /*p*/, bool enter) {
  if (!enter) hovered_.reset();
  return true;
}

}  // namespace slalom
