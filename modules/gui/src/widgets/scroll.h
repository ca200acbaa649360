#pragma once

#include "widgets/element.h"

namespace slalom {

/// Vertical scrolling of a content in a view, with a bar at the right edge that can be dragged.
class Scroll {
 public:
  static constexpr double kBarWidth = 10;  ///< pixels

  /// Sets the height (pixels) of the content and the rectangle of the view in its element.
  void set(double content_height, const ScreenRect& view);
  double offset() const { return offset_; }  ///< of the upper edge of the view in the content
  double max_offset() const;
  void to(double offset);  ///< clamped
  void by(double pixels) { to(offset_ + pixels); }
  void wheel(double steps) { by(-kWheelStep * steps); }
  void show(double top, double bottom);  ///< brings this part of the content into view

  std::optional<ScreenRect> thumb() const;  ///< none if everything is in view
  void draw(NVGcontext* ctx) const;
  bool press(const Element::Point& at);  ///< returns whether it is on the bar
  bool drag(const Element::Point& at);   ///< returns whether the bar is dragged
  void release() { grip_.reset(); }

 private:
  static constexpr double kWheelStep = 56;  ///< pixels
  double offset_ = 0, content_ = 0;
  ScreenRect view_;
  std::optional<double> grip_;  ///< from the top of the thumb to the mouse while it is dragged
};

}  // namespace slalom
