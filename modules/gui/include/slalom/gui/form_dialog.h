#pragma once

#include <slalom/gui/form_panel.h>

namespace slalom {

/// A modal window with a form in it.
class FormDialog : public nanogui::Window {
 public:
  FormDialog(nanogui::Screen& screen, FormDescription description);

  FormPanel& panel() { return *panel_; }

  void draw(NVGcontext* ctx) override;
  nanogui::Vector2i preferredSize(NVGcontext* ctx) const override;
  void performLayout(NVGcontext* ctx) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;
  bool keyboardCharacterEvent(unsigned int letter) override;

 private:
  FormPanel* panel_;
};

/// Shows a form in the middle of the screen, in front of all else, with the keyboard at its first
/// field. It closes itself.
FormDialog& open_form(nanogui::Screen& screen, FormDescription description);

}  // namespace slalom
