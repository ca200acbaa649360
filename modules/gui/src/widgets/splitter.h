#pragma once

#include "widgets/element.h"

#include <functional>
#include <string>

namespace slalom {

/// A bar between two panels that is dragged to resize them.
class Splitter : public Element {
 public:
  enum class DragAxis { Horizontal, Vertical };
  /// `on_move` gets the movement in pixels, to the right or down.
  Splitter(nanogui::Widget* parent, const std::string& id, DragAxis axis,
           std::function<void(int)> on_move);

  bool mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                      int modifiers) override;

  static constexpr int kThickness = 6;  ///< pixels

 protected:
  void paint(NVGcontext* ctx) override;

 private:
  DragAxis axis_;
  std::function<void(int)> on_move_;
};

}  // namespace slalom
