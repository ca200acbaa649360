#pragma once

#include <slalom/gui/element.h>

#include <functional>
#include <string>

namespace slalom {

/// A bar between two panels that is dragged to give one of them more room.
class Splitter : public Element {
 public:
  enum class Moves { Across, UpAndDown };
  /// `on_move` is told by how many pixels, to the right or down.
  Splitter(nanogui::Widget* parent, const std::string& id, Moves moves,
           std::function<void(int)> on_move);

  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                      int modifiers) override;

  static constexpr int kThickness = 6;  ///< pixels

 private:
  Moves moves_;
  std::function<void(int)> on_move_;
};

}  // namespace slalom
