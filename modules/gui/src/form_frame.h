#pragma once

#include <slalom/gui/drawing.h>

#include <algorithm>
#include <nanogui/nanogui.h>
#include <nanovg.h>
#include <string>

namespace slalom::form_frame {

/// Measures of a form's panel, pixels.
constexpr double kMargin = 16, kTitleHeight = 44, kButtonWidth = 120;

/// A form has room for what is wrong above its buttons.
inline double foot_height(bool is_message) {
  return is_message ? 56 : 96;
}

inline double wrapped_height(NVGcontext* ctx, const std::string& text, double width) {
  nvgFontFace(ctx, "sans");
  nvgFontSize(ctx, draw::kTextSize);
  nvgTextAlign(ctx, NVG_ALIGN_LEFT | NVG_ALIGN_TOP);
  float bounds[4];
  nvgTextBoxBounds(ctx, 0, 0, static_cast<float>(width), text.c_str(), nullptr, bounds);
  return bounds[3] - bounds[1];
}

}  // namespace slalom::form_frame
