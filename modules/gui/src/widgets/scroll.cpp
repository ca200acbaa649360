#include "widgets/drawing.h"
#include "widgets/scroll.h"

#include <algorithm>

namespace slalom {

void Scroll::set(double content_height, const ScreenRect& view) {
  content_ = content_height;
  view_ = view;
  to(offset_);
}

double Scroll::max_offset() const {
  return std::max(content_ - view_.height, 0.0);
}

void Scroll::to(double offset) {
  offset_ = std::clamp(offset, 0.0, max_offset());
}

void Scroll::show(double top, double bottom) {
  to(std::min(std::max(offset_, bottom - view_.height), top));
}

std::optional<ScreenRect> Scroll::thumb() const {
  constexpr double kMinThumb = 28;
  if (max_offset() <= 0) return std::nullopt;
  const double length =
      std::min(std::max(view_.height * view_.height / content_, kMinThumb), view_.height);
  const double top = view_.top + (view_.height - length) * offset_ / max_offset();
  return ScreenRect{view_.right() - kBarWidth, top, kBarWidth, length};
}

void Scroll::draw(NVGcontext* ctx) const {
  const auto shown = thumb();
  if (!shown) return;
  draw::fill(ctx, {shown->left, view_.top, kBarWidth, view_.height}, palette().window);
  draw::fill(ctx, {shown->left + 2, shown->top + 1, kBarWidth - 4, shown->height - 2},
             grip_ ? palette().accent : palette().faint_text, 3);
}

bool Scroll::press(const Element::Point& at) {
  const auto shown = thumb();
  if (!shown || at.x < shown->left || !view_.contains(at)) return false;
  if (shown->contains(at))
    grip_ = at.y - shown->top;
  else
    by(at.y < shown->top ? -view_.height : view_.height);
  return true;
}

bool Scroll::drag(const Element::Point& at) {
  const auto shown = thumb();
  if (!grip_ || !shown) return false;
  to((at.y - *grip_ - view_.top) / std::max(view_.height - shown->height, 1.0) * max_offset());
  return true;
}

}  // namespace slalom
