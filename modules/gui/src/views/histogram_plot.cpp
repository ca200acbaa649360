#include "views/histogram_plot.h"
#include "widgets/drawing.h"

#include <algorithm>

namespace slalom {
namespace {

std::string missing_text(const Histogram& histogram) {
  std::string text;
  if (histogram.na > 0) text = std::to_string(histogram.na) + " NA";
  if (histogram.not_computed > 0)
    text += (text.empty() ? "" : ", ") + std::to_string(histogram.not_computed) + " not computed";
  return text;
}

}  // namespace

void HistogramPlot::update() {
  const DescriptorModel& model = studio_.descriptors().model();
  const auto& values = studio_.descriptors().list_values();
  const ListColumn* column = values ? values->column(info().id) : nullptr;
  histogram_ = column ? make_histogram(*column) : Histogram();
  hovered_.reset();
  const DescriptorModel::Row& row = model.selected_row();
  current_.reset();
  if (row.state == DescriptorModel::State::Known && !row.described.value.is_na())
    current_ = row.described.value.number();
  else if (values)
    current_ = values->number(row.info.id, model.hash());
}

std::string HistogramPlot::message() const {
  if (!histogram_.bars.empty()) return "";
  const auto& values = studio_.descriptors().list_values();
  return values && values->column(info().id) ? "no values of " + info().name
                                             : studio_.descriptors().list_message();
}

PlotFrame HistogramPlot::frame() const {
  std::pair<double, double> range = {0, 1};
  if (!histogram_.bars.empty()) range = {histogram_.bars.front().low, histogram_.bars.back().high};
  const auto max = static_cast<double>(std::max<std::size_t>(histogram_.max_count(), 1));
  PlotFrame frame = PlotFrame::within(area(), range, {0, 1.08 * max});
  frame.integer_y = true;
  return frame;
}

ScreenRect HistogramPlot::bar_rect(const PlotFrame& frame, std::size_t bar, bool full) const {
  const Histogram::Bar& what = histogram_.bars[bar];
  const double left = frame.x.to_pixel(what.low), right = frame.x.to_pixel(what.high);
  const double top = full ? frame.area.top : frame.y.to_pixel(static_cast<double>(what.count));
  return {left, top, right - left, frame.area.bottom() - top};
}

std::optional<std::size_t> HistogramPlot::bar_at(const Point& at) const {
  const PlotFrame shown = frame();
  return shown.area.contains(at) ? histogram_.bar_of(shown.x.to_value(at.x)) : std::nullopt;
}

std::string HistogramPlot::bar_text(std::size_t bar) const {
  const Histogram::Bar& what = histogram_.bars[bar];
  const std::string unit = info().unit == "-" ? "" : " " + info().unit;
  return what.label + unit + ": " + std::to_string(what.count);
}

/// What the mouse is over, or how many scenarios are in no bar.
std::string HistogramPlot::remark() const {
  return hovered_ ? bar_text(*hovered_) : missing_text(histogram_);
}

std::string HistogramPlot::text() const {
  std::string text = "histogram of " + x_title();
  if (histogram_.bars.empty()) text += "\n" + message();
  for (std::size_t bar = 0; bar < histogram_.bars.size(); ++bar) {
    const bool here = current_ && histogram_.bar_of(*current_) == bar;
    text += "\n" + bar_text(bar) + (here ? " <- current " + descriptor_number(*current_) : "");
  }
  const std::string others = missing_text(histogram_);
  if (!others.empty()) text += "\n" + others;
  if (hovered_) text += "\nunder the mouse: " + bar_text(*hovered_);
  return text;
}

std::vector<Element::Part> HistogramPlot::parts() const {
  std::vector<Part> all = Plot::parts();
  const PlotFrame shown = frame();
  for (std::size_t bar = 0; bar < histogram_.bars.size(); ++bar)
    all.push_back({"bin " + std::to_string(bar), bar_rect(shown, bar, true)});
  if (const auto bar = current_ ? histogram_.bar_of(*current_) : std::nullopt)
    all.push_back({"current", bar_rect(shown, *bar, true)});
  return all;
}

void HistogramPlot::paint_data(NVGcontext* ctx, const PlotFrame& frame) {
  for (std::size_t bar = 0; bar < histogram_.bars.size(); ++bar) {
    if (hovered_ == bar) draw::fill(ctx, bar_rect(frame, bar, true), palette().hover);
    if (histogram_.bars[bar].count == 0) continue;
    ScreenRect rect = bar_rect(frame, bar, false);
    if (rect.width > 6) rect = rect.inset(1);
    rect = {rect.left, std::min(rect.top, rect.bottom() - 1), rect.width,
            std::max(rect.height, 1.0)};
    draw::fill(ctx, rect, hovered_ == bar ? palette().text : palette().accent);
  }
  if (current_ && histogram_.bar_of(*current_)) {
    const double at = frame.x.to_pixel(*current_), top = frame.area.top;
    draw::line(ctx, at, top, at, frame.area.bottom(), plot_mark_color(), 2);
    draw::triangle(ctx, {at - 5, top}, {at + 5, top}, {at, top + 8}, plot_mark_color());
  }
}

bool HistogramPlot::press(const Point& at, int /*modifiers*/) {
  if (const auto bar = bar_at(at))
    studio_.filter_range(info().id, histogram_.bars[*bar].low, histogram_.bars[*bar].high);
  return true;
}

void HistogramPlot::hover(const std::optional<Point>& at) {
  hovered_ = at ? bar_at(*at) : std::nullopt;
}

}  // namespace slalom
