// SPDX-License-Identifier: BSD-3-Clause
#include "views/filter_box.h"
#include "widgets/drawing.h"

#include <GLFW/glfw3.h>
#include <utility>

namespace slalom {

FilterBox::FilterBox(nanogui::Widget* parent, std::function<void()> left)
    : TextBox(parent, ""), left_(std::move(left)) {
  setId("filter");
  setEditable(true);
  setAlignment(Alignment::Left);
  setPlaceholder("filter: density > 0.2 and tag = hard");
}

void FilterBox::set_text(const std::string& text) {
  mValue = mValueTemp = text;
  if (focused()) select_text();
}

void FilterBox::select_text() {
  mSelectionPos = 0;
  mCursorPos = static_cast<int>(mValueTemp.size());
}

/// nanogui's own colors of text and placeholder have too little contrast and hardly differ.
void FilterBox::draw(NVGcontext* ctx) {
  if (own_theme_.get() == nullptr) setTheme(own_theme_ = new nanogui::Theme(*theme()));
  own_theme_->mTextColor = draw::nvg(palette().text);
  own_theme_->mDisabledTextColor = draw::nvg(palette().faint_text);
  setFontSize(15);  // setTheme() resets it
  TextBox::draw(ctx);
}

bool FilterBox::keyboardEvent(int key, int scancode, int action, int modifiers) {
  const bool pressed = focused() && action != GLFW_RELEASE;
  if (pressed && key == GLFW_KEY_ESCAPE) {
    mValueTemp = mValue;
    left_();
    return true;
  }
  if (!pressed || (key != GLFW_KEY_ENTER && key != GLFW_KEY_KP_ENTER))
    return TextBox::keyboardEvent(key, scancode, action, modifiers);
  focusEvent(false);  // applies the text
  focusEvent(true);
  select_text();
  return true;
}

}  // namespace slalom
