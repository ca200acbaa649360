// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <functional>
#include <nanogui/nanogui.h>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A rectangle of the screen, pixels.
struct ScreenRect {
  double left = 0, top = 0, width = 0, height = 0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
  mrpt::math::TPoint2D center() const { return {left + 0.5 * width, top + 0.5 * height}; }
  bool contains(double x, double y) const {
    return x >= left && x < right() && y >= top && y < bottom();
  }
  bool contains(const mrpt::math::TPoint2D& p) const { return contains(p.x, p.y); }
  ScreenRect inset(double by) const { return {left + by, top, width - 2 * by, height}; }
};

/// One visible part of the window. Elements contain elements (Composite, as nanogui's widgets do);
/// scripts, tests and the layout find them by id. Positions are pixels from the element's corner.
class Element : public nanogui::Widget {
 public:
  using Point = mrpt::math::TPoint2D;
  struct Part {
    std::string name;
    ScreenRect rect;
  };
  enum class Focus { None, OnPress };
  struct KeyAction {
    std::vector<int> keys;  ///< of GLFW
    std::function<void()> run;
  };

  Element(nanogui::Widget* parent, const std::string& id, Focus focus = Focus::None)
      : Widget(parent), focus_(focus) {
    setId(id);
  }

  /// Its content as plain text.
  virtual std::string text() const { return ""; }
  /// The rectangle of a part that is not an element, "row 3", "slider": its own, or of a visible
  /// child. nullopt if it is not visible. The empty name is the whole element.
  virtual std::optional<ScreenRect> rect_of(const std::string& part) const;
  /// Handles a click on a part; the empty name is none of them.
  virtual void click(const std::string& /*part*/) {}
  ScreenRect area() const;
  void set_bounds(const ScreenRect& rect);

  // Functions of nanogui; they call the functions below, children first.
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;
  bool mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                      int modifiers) override;
  bool mouseEnterEvent(const nanogui::Vector2i& p, bool enter) override;
  bool scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 protected:
  /// The parts that are visible now; the first of overlapping ones is on top.
  virtual std::vector<Part> parts() const { return {}; }
  std::string part_at(const Point& at) const;  ///< empty for none
  /// Draws what is below the children, clipped to the element.
  virtual void paint(NVGcontext*) {}
  virtual bool press(const Point& at, int /*modifiers*/);  ///< the left button
  virtual void press_right(const Point&) {}                ///< the right button
  virtual void release(const Point&) {}
  virtual void drag(const Point&) {}
  virtual void hover(const std::optional<Point>&) {}  ///< none: the mouse has left
  virtual bool wheel(const Point&, double /*steps, up is positive*/) { return false; }
  virtual bool key(int /*key*/, int /*modifiers*/) { return false; }  ///< pressed or repeated
  /// Runs the action of a key. Returns whether there is one.
  static bool run_key(int key, const std::vector<KeyAction>& actions);

  Point local(const nanogui::Vector2i& p) const;

 private:
  Focus focus_;
};

}  // namespace slalom
