#pragma once

#include <nanogui/nanogui.h>
#include <optional>
#include <string>

namespace slalom {

/// A rectangle of the screen, pixels.
struct ScreenRect {
  double left = 0, top = 0, width = 0, height = 0;
  bool contains(double x, double y) const {
    return x >= left && x < left + width && y >= top && y < top + height;
  }
};

/// One visible part of the window. Elements hold elements (Composite, as nanogui's widgets do);
/// each has an id by which scripts, tests and the layout find it.
class Element : public nanogui::Widget {
 public:
  Element(nanogui::Widget* parent, const std::string& id) : Widget(parent) { setId(id); }

  /// What it shows as plain lines.
  virtual std::string text() const { return ""; }
  /// Where a part that has no element of its own lies, relative to this element: "row 3", "slider".
  /// nullopt when it is not shown. The empty name is the element as a whole.
  virtual std::optional<ScreenRect> rect_of(const std::string& part) const {
    if (!part.empty()) return std::nullopt;
    return ScreenRect{0, 0, static_cast<double>(width()), static_cast<double>(height())};
  }
};

}  // namespace slalom
