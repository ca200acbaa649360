#include <slalom/gui/descriptor_model.h>
#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/scatter_plot.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using Range = std::pair<double, double>;

constexpr double kPickRadius = 6;  ///< pixels
constexpr double kLeastDrag = 4;   ///< pixels; less is a click

/// A little room on both sides, so that dots are not cut.
Range with_room(const std::optional<Range>& range) {
  if (!range) return {0, 1};
  const double room = 0.03 * (range->second - range->first);
  return {range->first - room, range->second + room};
}

}  // namespace

ScatterPlot::ScatterPlot(nanogui::Widget* parent) : Element(parent, "scatter") {}

void ScatterPlot::set_values(std::shared_ptr<const ListValues> values, const QuantityInfo& x,
                             const QuantityInfo& y, std::string message) {
  values_ = std::move(values);
  x_info_ = x;
  y_info_ = y;
  message_ = std::move(message);
  const ListColumn* across = values_ ? values_->column(x.id) : nullptr;
  const ListColumn* up = values_ ? values_->column(y.id) : nullptr;
  scatter_ = across && up ? Scatter(*across, *up) : Scatter();
  drag_.reset();
  chosen_.reset();
  image_outdated_ = true;
}

void ScatterPlot::set_current(const std::string& hash) {
  current_ = hash;
}

PlotFrame ScatterPlot::frame() const {
  return PlotFrame::within(*Element::rect_of(""), with_room(scatter_.x_range()),
                           with_room(scatter_.y_range()));
}

std::optional<ScatterPlot::Corner> ScatterPlot::current_point() const {
  if (!values_) return std::nullopt;
  const auto x = values_->number(x_info_.id, current_), y = values_->number(y_info_.id, current_);
  return x && y ? std::optional(Corner{*x, *y}) : std::nullopt;
}

ScatterPlot::Corner ScatterPlot::corner_at(const nanogui::Vector2i& p) const {
  const PlotFrame shown = frame();
  const ScreenRect& area = shown.area;
  const double x = std::clamp<double>(p.x() - mPos.x(), area.left, area.left + area.width);
  const double y = std::clamp<double>(p.y() - mPos.y(), area.top, area.top + area.height);
  return {shown.x.to_value(x), shown.y.to_value(y)};
}

ScreenRect ScatterPlot::rect_between(const PlotFrame& frame, const Drag& drag) const {
  const auto [left, right] =
      std::minmax({frame.x.to_pixel(drag.from.x), frame.x.to_pixel(drag.to.x)});
  const auto [top, bottom] =
      std::minmax({frame.y.to_pixel(drag.from.y), frame.y.to_pixel(drag.to.y)});
  return {left, top, right - left, bottom - top};
}

std::string ScatterPlot::summary() const {
  std::string text = std::to_string(scatter_.points().size()) + " scenarios";
  if (chosen_) text = std::to_string(chosen_count_) + " chosen of " + text;
  if (scatter_.left_out() > 0)
    text += ", " + std::to_string(scatter_.left_out()) + " without both values";
  return text;
}

std::string ScatterPlot::text() const {
  std::string text = with_unit(y_info_.name, y_info_.unit) + " over " +
                     with_unit(x_info_.name, x_info_.unit) + "\n";
  if (scatter_.points().empty()) return text + message_;
  text += summary();
  if (const auto here = current_point())
    text += "\ncurrent " + descriptor_number(here->x) + ", " + descriptor_number(here->y);
  return text;
}

std::optional<ScreenRect> ScatterPlot::rect_of(const std::string& part) const {
  const PlotFrame shown = frame();
  if (part == "plot") return shown.area;
  if (part == "selection" && chosen_) return rect_between(shown, *chosen_);
  const auto here = part == "current" ? current_point() : std::nullopt;
  if (!here) return Element::rect_of(part);
  return ScreenRect{shown.x.to_pixel(here->x) - 4, shown.y.to_pixel(here->y) - 4, 8, 8};
}

void ScatterPlot::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  draw::fill(ctx, *Element::rect_of(""), palette().panel);
  const PlotFrame shown = frame();
  if (scatter_.points().empty()) {
    draw::text(ctx, *Element::rect_of(""), message_, palette().faint_text, draw::kTextSize,
               draw::Align::Center);
  } else {
    shown.draw(ctx, with_unit(x_info_.name, x_info_.unit), with_unit(y_info_.name, y_info_.unit));
    draw_points(ctx, shown);
    draw_marks(ctx, shown);
    const double most = 0.7 * shown.area.width;
    draw::text(ctx, {shown.area.left + shown.area.width - most, 1, most, shown.area.top - 2},
               summary(), palette().faint_text, draw::kSmallTextSize, draw::Align::Right);
  }
  nvgRestore(ctx);
}

void ScatterPlot::update_image(NVGcontext* ctx, const PlotFrame& frame) {
  const int wide = static_cast<int>(frame.area.width), tall = static_cast<int>(frame.area.height);
  const bool same_size = wide == image_width_ && tall == image_height_;
  if (image_ != 0 && same_size && !image_outdated_) return;
  const auto picture = draw_dots(scatter_, frame.x, frame.y, static_cast<int>(frame.area.left),
                                 static_cast<int>(frame.area.top), wide, tall, palette().accent);
  if (image_ != 0 && same_size) {
    nvgUpdateImage(ctx, image_, picture.data());
  } else {
    if (image_ != 0) nvgDeleteImage(ctx, image_);
    image_ = nvgCreateImageRGBA(ctx, wide, tall, NVG_IMAGE_NEAREST, picture.data());
  }
  image_width_ = wide;
  image_height_ = tall;
  image_outdated_ = false;
}

void ScatterPlot::draw_points(NVGcontext* ctx, const PlotFrame& frame) {
  if (frame.area.width < 2 || frame.area.height < 2) return;
  update_image(ctx, frame);
  const auto left = static_cast<float>(frame.area.left), top = static_cast<float>(frame.area.top);
  const auto wide = static_cast<float>(image_width_), tall = static_cast<float>(image_height_);
  nvgBeginPath(ctx);
  nvgRect(ctx, left, top, wide, tall);
  nvgFillPaint(ctx, nvgImagePattern(ctx, left, top, wide, tall, 0, image_, 1));
  nvgFill(ctx);
}

void ScatterPlot::draw_marks(NVGcontext* ctx, const PlotFrame& frame) const {
  if (const auto here = current_point()) {
    nvgBeginPath(ctx);
    nvgCircle(ctx, static_cast<float>(frame.x.to_pixel(here->x)),
              static_cast<float>(frame.y.to_pixel(here->y)), 6);
    nvgStrokeColor(ctx, plot_mark_color());
    nvgStrokeWidth(ctx, 2.5F);
    nvgStroke(ctx);
  }
  const std::optional<Drag>& shown = drag_ && drag_->moved ? drag_ : chosen_;
  if (!shown) return;
  nanogui::Color inside = plot_mark_color();
  inside.w() = 0.15F;
  draw::fill(ctx, rect_between(frame, *shown), inside);
  draw::frame(ctx, rect_between(frame, *shown), plot_mark_color());
}

bool ScatterPlot::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down,
                                   int /*modifiers*/) {
  if (button != GLFW_MOUSE_BUTTON_LEFT || scatter_.points().empty()) return false;
  const bool inside = frame().area.contains(p.x() - mPos.x(), p.y() - mPos.y());
  if (down && inside) drag_ = Drag{corner_at(p), corner_at(p)};
  if (!down && drag_) release(p);
  return true;
}

bool ScatterPlot::mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& /*rel*/,
                                 int /*button*/, int /*modifiers*/) {
  if (!drag_) return false;
  drag_->to = corner_at(p);
  const ScreenRect rect = rect_between(frame(), *drag_);
  drag_->moved = drag_->moved || rect.width >= kLeastDrag || rect.height >= kLeastDrag;
  return true;
}

void ScatterPlot::release(const nanogui::Vector2i& p) {
  const Drag drag = *drag_;
  drag_.reset();
  chosen_.reset();
  if (!drag.moved) {
    const PlotFrame shown = frame();
    const auto row =
        scatter_.nearest(shown.x, shown.y, p.x() - mPos.x(), p.y() - mPos.y(), kPickRadius);
    if (row && on_pick) on_pick(values_->hash(*row));
    return;
  }
  std::vector<std::string> hashes;
  for (const std::size_t row : scatter_.within(drag.from.x, drag.from.y, drag.to.x, drag.to.y))
    hashes.push_back(values_->hash(row));
  chosen_ = drag;
  chosen_count_ = hashes.size();
  if (on_select) on_select(hashes);
}

}  // namespace slalom
