// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/drawing.h"

#include <functional>
#include <string>

namespace slalom {

/// A bar between two panels that is dragged to resize them.
class Splitter : public Element {
 public:
  static constexpr int kThickness = 6;  ///< pixels
  enum class DragAxis { Horizontal, Vertical };
  /// `on_move` gets the movement in pixels, to the right or down.
  Splitter(nanogui::Widget* parent, const std::string& id, DragAxis axis,
           std::function<void(int)> on_move)
      : Element(parent, id), axis_(axis), on_move_(std::move(on_move)) {
    setCursor(axis == DragAxis::Horizontal ? nanogui::Cursor::HResize : nanogui::Cursor::VResize);
  }

  bool mouseDragEvent(const nanogui::Vector2i&, const nanogui::Vector2i& rel, int, int) override {
    on_move_(axis_ == DragAxis::Horizontal ? rel.x() : rel.y());
    return true;
  }

 protected:
  void paint(NVGcontext* ctx) override {
    draw::fill(ctx, area(), mMouseFocus ? palette().accent : palette().window);
  }

 private:
  DragAxis axis_;
  std::function<void(int)> on_move_;
};

}  // namespace slalom
