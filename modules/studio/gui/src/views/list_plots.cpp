// SPDX-License-Identifier: BSD-3-Clause
#include "views/panels.h"
#include "widgets/drawing.h"

#include <slalom/core/text.h>

#include <algorithm>
#include <optional>

namespace slalom {
namespace {

/// The color of the current scenario and of the selection.
const Color& plot_mark_color() {
  return palette().edit;
}

/// "Clearance (m)"; only the name if the unit is "-" or empty.
std::string with_unit(const QuantityInfo& info) {
  return info.unit.empty() || info.unit == "-" ? info.name : info.name + " (" + info.unit + ")";
}

std::string missing_text(const Histogram& histogram) {
  std::string text;
  if (histogram.na > 0) text = std::to_string(histogram.na) + " NA";
  if (histogram.not_computed > 0)
    text += (text.empty() ? "" : ", ") + std::to_string(histogram.not_computed) + " not computed";
  return text;
}

constexpr double kPickRadius = 6;  ///< pixels

/// Adds a margin on both sides, so that dots are not cut off.
Interval with_margin(const std::optional<Interval>& range) {
  if (!range) return {0, 1};
  const double margin = 0.03 * (range->second - range->first);
  return {range->first - margin, range->second + margin};
}

/// A histogram of the active list with the current scenario marked. A click on a bar filters the
/// list by its range. Parts: "plot", "bin 0", "bin 1", ..., "current".
class HistogramPlot : public ListPlot {
 public:
  HistogramPlot(nanogui::Widget* parent, Studio& studio)
      : ListPlot(parent, "histogram"), studio_(studio) {}
  void update(const QuantityInfo& info, const QuantityInfo& /*y*/) override {
    info_ = info;
    const DescriptorModel& model = studio_.descriptors().model();
    const auto& values = studio_.descriptors().list_values();
    const ListColumn* column = values ? values->column(info_.id) : nullptr;
    histogram_ = column ? make_histogram(*column) : Histogram();
    hovered_.reset();
    const DescriptorModel::Row& row = model.selected_row();
    current_.reset();
    if (row.state == DescriptorModel::State::Known && !row.described.value.is_na())
      current_ = row.described.value.number();
    else if (values)
      current_ = values->number(row.info.id, model.hash());
  }
  std::string text() const override {
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

 protected:
  PlotFrame frame() const override {
    Interval range = {0, 1};
    if (!histogram_.bars.empty())
      range = {histogram_.bars.front().low, histogram_.bars.back().high};
    const auto max = static_cast<double>(std::max<std::size_t>(histogram_.max_count(), 1));
    PlotFrame frame = PlotFrame::within(area(), range, {0, 1.08 * max});
    frame.integer_y = true;
    return frame;
  }
  std::string message() const override {
    if (!histogram_.bars.empty()) return "";
    const auto& values = studio_.descriptors().list_values();
    return values && values->column(info_.id) ? "no values of " + info_.name
                                              : studio_.descriptors().list_message();
  }
  std::string x_title() const override { return with_unit(info_); }
  std::string y_title() const override { return "scenarios"; }
  /// Names the bar under the mouse, or counts the scenarios that are in no bar.
  std::string remark() const override {
    return hovered_ ? bar_text(*hovered_) : missing_text(histogram_);
  }
  void paint_data(NVGcontext* ctx, const PlotFrame& frame) override {
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
  std::vector<Part> parts() const override {
    std::vector<Part> all = Plot::parts();
    const PlotFrame shown = frame();
    for (std::size_t bar = 0; bar < histogram_.bars.size(); ++bar)
      all.push_back({"bin " + std::to_string(bar), bar_rect(shown, bar, true)});
    if (const auto bar = current_ ? histogram_.bar_of(*current_) : std::nullopt)
      all.push_back({"current", bar_rect(shown, *bar, true)});
    return all;
  }
  bool press(const Point& at, int /*modifiers*/) override {
    if (const auto bar = bar_at(at))
      studio_.filter_range(info_.id, histogram_.bars[*bar].low, histogram_.bars[*bar].high);
    return true;
  }
  void hover(const std::optional<Point>& at) override {
    hovered_ = at ? bar_at(*at) : std::nullopt;
  }

 private:
  Studio& studio_;
  QuantityInfo info_;
  Histogram histogram_;
  std::optional<double> current_;
  std::optional<std::size_t> hovered_;

  ScreenRect bar_rect(const PlotFrame& frame, std::size_t bar, bool full) const {
    const Histogram::Bar& what = histogram_.bars[bar];
    const double left = frame.x.to_pixel(what.low), right = frame.x.to_pixel(what.high);
    const double top = full ? frame.area.top : frame.y.to_pixel(static_cast<double>(what.count));
    return {left, top, right - left, frame.area.bottom() - top};
  }
  std::optional<std::size_t> bar_at(const Point& at) const {
    const PlotFrame shown = frame();
    return shown.area.contains(at) ? histogram_.bar_of(shown.x.to_value(at.x)) : std::nullopt;
  }
  std::string bar_text(std::size_t bar) const {
    const Histogram::Bar& what = histogram_.bars[bar];
    const std::string unit = info_.unit == "-" ? "" : " " + info_.unit;
    return what.label + unit + ": " + std::to_string(what.count);
  }
};

/// A scatter plot of the active list over two descriptors, the current scenario marked. Dragging
/// selects the scenarios in a rectangle, a click makes the scenario under the mouse current. Parts:
/// "plot", "current", "selection".
class ScatterPlot : public ListPlot {
 public:
  ScatterPlot(nanogui::Widget* parent, Studio& studio)
      : ListPlot(parent, "scatter"), studio_(studio) {}
  void update(const QuantityInfo& x, const QuantityInfo& y) override {
    const auto& values = studio_.descriptors().list_values();
    if (values == values_ && x.id == x_info_.id && y.id == y_info_.id) return;
    values_ = values;
    x_info_ = x;
    y_info_ = y;
    const ListColumn* across = values_ ? values_->column(x.id) : nullptr;
    const ListColumn* up = values_ ? values_->column(y.id) : nullptr;
    scatter_ = across && up ? Scatter(*across, *up) : Scatter();
    drag_.reset();
    selection_.reset();
    image_outdated_ = true;
  }
  std::string text() const override {
    std::string text = y_title() + " over " + x_title() + "\n" + message() + remark();
    if (const auto here = scatter_.points().empty() ? std::nullopt : current_point())
      text += "\ncurrent " + descriptor_number(here->x) + ", " + descriptor_number(here->y);
    return text;
  }

 protected:
  PlotFrame frame() const override {
    return PlotFrame::within(area(), with_margin(scatter_.x_range()),
                             with_margin(scatter_.y_range()));
  }
  std::string message() const override {
    if (!scatter_.points().empty()) return "";
    const bool read = values_ && values_->column(x_info_.id) && values_->column(y_info_.id);
    return read ? "no scenario has both values" : studio_.descriptors().list_message();
  }
  std::string x_title() const override { return with_unit(x_info_); }
  std::string y_title() const override { return with_unit(y_info_); }
  std::string remark() const override {
    if (scatter_.points().empty()) return "";
    std::string text = count_text(scatter_.points().size(), "scenario");
    if (selection_) text = std::to_string(selected_count_) + " selected of " + text;
    if (scatter_.skipped() > 0)
      text += ", " + std::to_string(scatter_.skipped()) + " without both values";
    return text;
  }
  void paint_data(NVGcontext* ctx, const PlotFrame& frame) override {
    if (frame.area.width < 2 || frame.area.height < 2) return;
    update_image(ctx, frame);
    draw::image(ctx,
                {frame.area.left, frame.area.top, static_cast<double>(image_width_),
                 static_cast<double>(image_height_)},
                image_);
    draw_marks(ctx, frame);
  }
  std::vector<Part> parts() const override {
    std::vector<Part> all = Plot::parts();
    const PlotFrame shown = frame();
    if (selection_) all.push_back({"selection", rect_between(shown, *selection_)});
    if (const auto here = current_point())
      all.push_back(
          {"current", {shown.x.to_pixel(here->x) - 4, shown.y.to_pixel(here->y) - 4, 8, 8}});
    return all;
  }
  bool press(const Point& at, int /*modifiers*/) override {
    if (scatter_.points().empty()) return false;
    if (frame().area.contains(at)) drag_ = Drag{value_at(at), value_at(at)};
    return true;
  }
  void drag(const Point& at) override {
    if (!drag_) return;
    drag_->to = value_at(at);
    const ScreenRect rect = rect_between(frame(), *drag_);
    drag_->moved = drag_->moved || rect.width >= draw::kMinDrag || rect.height >= draw::kMinDrag;
  }
  void release(const Point& at) override {
    ListDocument* list = studio_.active();
    if (!drag_ || list == nullptr) return;
    const Drag drag = *drag_;
    drag_.reset();
    selection_.reset();
    if (!drag.moved) {
      const PlotFrame shown = frame();
      const auto row = scatter_.nearest(shown.x, shown.y, at.x, at.y, kPickRadius);
      if (row) list->set_current(values_->hash(*row));
      return;
    }
    std::vector<std::string> hashes;
    for (const std::size_t row : scatter_.within(drag.from.x, drag.from.y, drag.to.x, drag.to.y))
      hashes.push_back(values_->hash(row));
    selection_ = drag;
    selected_count_ = hashes.size();
    list->select(hashes);
  }

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

  Point value_at(const Point& at) const {
    const PlotFrame shown = frame();
    const ScreenRect& area = shown.area;
    return {shown.x.to_value(std::clamp(at.x, area.left, area.right())),
            shown.y.to_value(std::clamp(at.y, area.top, area.bottom()))};
  }
  std::optional<Point> current_point() const {
    if (!values_) return std::nullopt;
    const std::string& hash = studio_.descriptors().model().hash();
    const auto x = values_->number(x_info_.id, hash), y = values_->number(y_info_.id, hash);
    return x && y ? std::optional(Point(*x, *y)) : std::nullopt;
  }
  ScreenRect rect_between(const PlotFrame& frame, const Drag& drag) const {
    const auto [left, right] =
        std::minmax({frame.x.to_pixel(drag.from.x), frame.x.to_pixel(drag.to.x)});
    const auto [top, bottom] =
        std::minmax({frame.y.to_pixel(drag.from.y), frame.y.to_pixel(drag.to.y)});
    return {left, top, right - left, bottom - top};
  }
  void update_image(NVGcontext* ctx, const PlotFrame& frame) {
    const int wide = static_cast<int>(frame.area.width), tall = static_cast<int>(frame.area.height);
    const bool same_size = wide == image_width_ && tall == image_height_;
    if (image_ != 0 && same_size && !image_outdated_) return;
    const auto image = draw_dots(scatter_, frame.x, frame.y, static_cast<int>(frame.area.left),
                                 static_cast<int>(frame.area.top), wide, tall, palette().accent);
    if (image_ != 0 && same_size) {
      nvgUpdateImage(ctx, image_, image.data());
    } else {
      if (image_ != 0) nvgDeleteImage(ctx, image_);
      image_ = nvgCreateImageRGBA(ctx, wide, tall, NVG_IMAGE_NEAREST, image.data());
    }
    image_width_ = wide;
    image_height_ = tall;
    image_outdated_ = false;
  }
  void draw_marks(NVGcontext* ctx, const PlotFrame& frame) const {
    if (const auto here = current_point()) {
      nvgBeginPath(ctx);
      nvgCircle(ctx, static_cast<float>(frame.x.to_pixel(here->x)),
                static_cast<float>(frame.y.to_pixel(here->y)), 6);
      draw::stroke_path(ctx, plot_mark_color(), 2.5F);
    }
    const std::optional<Drag>& shown = drag_ && drag_->moved ? drag_ : selection_;
    if (!shown) return;
    draw::fill(ctx, rect_between(frame, *shown), faded(plot_mark_color(), 0.15));
    draw::frame(ctx, rect_between(frame, *shown), plot_mark_color());
  }
};

}  // namespace

ListPlot* make_histogram(nanogui::Widget* parent, Studio& studio) {
  return new HistogramPlot(parent, studio);
}

ListPlot* make_scatter_plot(nanogui::Widget* parent, Studio& studio) {
  return new ScatterPlot(parent, studio);
}

}  // namespace slalom
