#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/splitter.h>

namespace slalom {

Splitter::Splitter(nanogui::Widget* parent, const std::string& id, Moves moves,
                   std::function<void(int)> on_move)
    : Element(parent, id), moves_(moves), on_move_(std::move(on_move)) {
  setCursor(moves == Moves::Across ? nanogui::Cursor::HResize : nanogui::Cursor::VResize);
}

void Splitter::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  draw::fill(ctx, *rect_of(""), mMouseFocus ? palette().accent : palette().window);
  nvgRestore(ctx);
}

bool Splitter::mouseButtonEvent(const nanogui::Vector2i&, int, bool, int) {
  return true;
}

bool Splitter::mouseDragEvent(const nanogui::Vector2i&, const nanogui::Vector2i& rel, int, int) {
  on_move_(moves_ == Moves::Across ? rel.x() : rel.y());
  return true;
}

}  // namespace slalom
