#include <slalom/gui/form_dialog.h>

namespace slalom {

FormDialog::FormDialog(nanogui::Screen& screen, FormDescription description)
    : Window(&screen, ""),
      panel_(new FormPanel(this, std::move(description), [this] { dispose(); })) {
  setModal(true);
  setId("form");
}

void FormDialog::draw(NVGcontext* ctx) {
  performLayout(ctx);
  Widget::draw(ctx);
}

nanogui::Vector2i FormDialog::preferredSize(NVGcontext*) const {
  return panel_->size();
}

void FormDialog::performLayout(NVGcontext* ctx) {
  const nanogui::Vector2i room = screen()->size();
  const nanogui::Vector2i before = panel_->size();
  panel_->fit(ctx, {room.x() - 40, room.y() - 60});
  panel_->setPosition({0, 0});
  if (panel_->size() == before) return;
  setSize(panel_->size());
  setPosition((room - size()) / 2);
}

bool FormDialog::keyboardEvent(int key, int scancode, int action, int modifiers) {
  const nanogui::ref<FormDialog> self = this;  // the panel may close it
  return panel_->keyboardEvent(key, scancode, action, modifiers);
}

bool FormDialog::keyboardCharacterEvent(unsigned int letter) {
  return panel_->keyboardCharacterEvent(letter);
}

FormDialog& open_form(nanogui::Screen& screen, FormDescription description) {
  auto* dialog = new FormDialog(screen, std::move(description));
  dialog->performLayout(screen.nvgContext());
  dialog->requestFocus();
  return *dialog;
}

}  // namespace slalom
