#include "widgets/drawing.h"
#include "widgets/splitter.h"

namespace slalom {

Splitter::Splitter(nanogui::Widget* parent, const std::string& id, DragAxis axis,
                   std::function<void(int)> on_move)
    : Element(parent, id), axis_(axis), on_move_(std::move(on_move)) {
  setCursor(axis == DragAxis::Horizontal ? nanogui::Cursor::HResize : nanogui::Cursor::VResize);
}

void Splitter::paint(NVGcontext* ctx) {
  draw::fill(ctx, area(), mMouseFocus ? palette().accent : palette().window);
}

bool Splitter::mouseDragEvent(const nanogui::Vector2i&, const nanogui::Vector2i& rel, int, int) {
  on_move_(axis_ == DragAxis::Horizontal ? rel.x() : rel.y());
  return true;
}

}  // namespace slalom
