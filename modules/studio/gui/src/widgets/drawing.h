// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/element.h"

#include <slalom/studio/palette.h>

#include <functional>
#include <nanovg.h>
#include <string>
#include <vector>

namespace slalom {

/// Whether `c` is a continuation byte of UTF-8.
inline bool is_continuation_byte(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Thin wrappers of NanoVG calls for elements. Sizes in pixels.
namespace draw {

constexpr float kTextSize = 15, kSmallTextSize = 13;

/// For calls of NanoVG and nanogui.
inline nanogui::Color nvg(const Color& color) {
  return {color.R, color.G, color.B, color.A};
}

enum class Align { Left, Center, Right };

/// Fill and stroke the path of `ctx`.
void fill_path(NVGcontext* ctx, const Color& color);
void stroke_path(NVGcontext* ctx, const Color& color, float width = 1);

void fill(NVGcontext* ctx, const ScreenRect& rect, const Color& color, float radius = 0);
void frame(NVGcontext* ctx, const ScreenRect& rect, const Color& color);
void line(NVGcontext* ctx, double x0, double y0, double x1, double y1, const Color& color,
          float width = 1);

void triangle(NVGcontext* ctx, const Element::Point& a, const Element::Point& b,
              const Element::Point& c, const Color& color);
void image(NVGcontext* ctx, const ScreenRect& rect, int image);
/// Restricts drawing to `rect`, until nvgRestore().
void clip(NVGcontext* ctx, const ScreenRect& rect);

/// Draws a check mark in the center of `rect`, 8 pixels wide; the font has none.
void check_mark(NVGcontext* ctx, const ScreenRect& rect, const Color& color);
/// A check box in the middle of the height of `rect`, at its left end.
void check_box(NVGcontext* ctx, const ScreenRect& rect, bool checked, bool focused = false);
constexpr double kCheckBox = 14;
/// A shorter drag is a click, pixels.
constexpr double kMinDrag = 4;

struct ButtonState {
  bool on = false, enabled = true, hovered = false, focused = false;
};
/// A button; of a focused one the frame is highlighted.
void button(NVGcontext* ctx, const ScreenRect& rect, const std::string& label,
            const ButtonState& state = {}, float size = kTextSize);
/// A tab, an active one highlighted; `text` is the space for its title.
void tab(NVGcontext* ctx, const ScreenRect& rect, const ScreenRect& text, const std::string& title,
         bool active, bool hovered = false, Align align = Align::Left);
/// The background of a row of a list.
void row(NVGcontext* ctx, const ScreenRect& rect, std::size_t index, bool selected, bool hovered);

/// Draws a line of text, vertically centered in `rect`; elided where it is too long.
void text(NVGcontext* ctx, const ScreenRect& rect, const std::string& text, const Color& color,
          float size = kTextSize, Align align = Align::Left, bool bold = false);
/// Draws text wrapped to the width of `rect`, from its top. Returns the height of the text.
double wrapped_text(NVGcontext* ctx, const ScreenRect& rect, const std::string& text,
                    const Color& color, float size = kTextSize);
double wrapped_height(NVGcontext* ctx, const std::string& text, double width,
                      float size = kTextSize);
/// Draws lines of two aligned columns, which a tab separates; lines without a tab are headings.
void two_columns(NVGcontext* ctx, const ScreenRect& rect, const std::string& text,
                 const Color& color);
double two_columns_height(const std::string& text);
double text_width(NVGcontext* ctx, const std::string& text, float size = kTextSize,
                  bool bold = false);
/// Returns `text`, or its beginning and "…" so that it fits into `width`.
std::string elided(NVGcontext* ctx, const std::string& text, double width, float size = kTextSize,
                   bool bold = false);
/// The same with another criterion of what fits.
std::string elided(const std::string& text,
                   const std::function<bool(const std::string& shown)>& fits);

}  // namespace draw
}  // namespace slalom
