// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <nanogui/nanogui.h>
#include <string>

namespace slalom {

/// The text field of a filter. Enter applies the text, keeps the focus and selects the text; Escape
/// restores the applied text and leaves the field; losing the focus applies the text, too.
class FilterBox : public nanogui::TextBox {
 public:
  /// `left` is called on Escape and moves the focus elsewhere.
  FilterBox(nanogui::Widget* parent, std::function<void()> left);

  /// Replaces the text, also while it is edited.
  void set_text(const std::string& text);
  void draw(NVGcontext* ctx) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 private:
  void select_text();

  std::function<void()> left_;
  nanogui::ref<nanogui::Theme> own_theme_;
};

}  // namespace slalom
