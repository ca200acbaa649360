// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/drawing.h"

#include <slalom/core/text.h>

#include <algorithm>

namespace slalom::draw {
namespace {

constexpr double kColumnsPitch = 20, kColumnGap = 24;  // pixels

void use_font(NVGcontext* ctx, float size, bool bold) {
  nvgFontFace(ctx, bold ? "sans-bold" : "sans");
  nvgFontSize(ctx, size);
}

void path_of(NVGcontext* ctx, const ScreenRect& rect, float radius) {
  nvgBeginPath(ctx);
  nvgRoundedRect(ctx, static_cast<float>(rect.left), static_cast<float>(rect.top),
                 static_cast<float>(rect.width), static_cast<float>(rect.height), radius);
}

}  // namespace

void fill_path(NVGcontext* ctx, const Color& color) {
  nvgFillColor(ctx, nvg(color));
  nvgFill(ctx);
}

void stroke_path(NVGcontext* ctx, const Color& color, float width) {
  nvgStrokeColor(ctx, nvg(color));
  nvgStrokeWidth(ctx, width);
  nvgStroke(ctx);
}

void fill(NVGcontext* ctx, const ScreenRect& rect, const Color& color, float radius) {
  path_of(ctx, rect, radius);
  fill_path(ctx, color);
}

void frame(NVGcontext* ctx, const ScreenRect& rect, const Color& color) {
  path_of(ctx, {rect.left + 0.5, rect.top + 0.5, rect.width - 1, rect.height - 1}, 0);
  stroke_path(ctx, color);
}

void line(NVGcontext* ctx, double x0, double y0, double x1, double y1, const Color& color,
          float width) {
  nvgBeginPath(ctx);
  nvgMoveTo(ctx, static_cast<float>(x0), static_cast<float>(y0));
  nvgLineTo(ctx, static_cast<float>(x1), static_cast<float>(y1));
  stroke_path(ctx, color, width);
}

void triangle(NVGcontext* ctx, const Element::Point& a, const Element::Point& b,
              const Element::Point& c, const Color& color) {
  nvgBeginPath(ctx);
  nvgMoveTo(ctx, static_cast<float>(a.x), static_cast<float>(a.y));
  nvgLineTo(ctx, static_cast<float>(b.x), static_cast<float>(b.y));
  nvgLineTo(ctx, static_cast<float>(c.x), static_cast<float>(c.y));
  fill_path(ctx, color);
}

void image(NVGcontext* ctx, const ScreenRect& rect, int image) {
  const auto left = static_cast<float>(rect.left), top = static_cast<float>(rect.top);
  path_of(ctx, rect, 0);
  nvgFillPaint(ctx, nvgImagePattern(ctx, left, top, static_cast<float>(rect.width),
                                    static_cast<float>(rect.height), 0, image, 1));
  nvgFill(ctx);
}

void clip(NVGcontext* ctx, const ScreenRect& rect) {
  nvgIntersectScissor(ctx, static_cast<float>(rect.left), static_cast<float>(rect.top),
                      static_cast<float>(rect.width), static_cast<float>(rect.height));
}

void check_mark(NVGcontext* ctx, const ScreenRect& rect, const Color& color) {
  const double x = rect.left + 0.5 * rect.width, y = rect.top + 0.5 * rect.height;
  line(ctx, x - 4, y, x - 1, y + 3, color, 2);
  line(ctx, x - 1, y + 3, x + 4, y - 3, color, 2);
}

void check_box(NVGcontext* ctx, const ScreenRect& rect, bool checked, bool focused) {
  const Palette& colors = palette();
  const ScreenRect box{rect.left, rect.top + 0.5 * (rect.height - kCheckBox), kCheckBox, kCheckBox};
  fill(ctx, box, checked ? colors.selected : colors.window, 2);
  frame(ctx, box, focused ? colors.accent : colors.faint_text);
  if (checked) check_mark(ctx, box, colors.text);
}

void button(NVGcontext* ctx, const ScreenRect& rect, const std::string& label,
            const ButtonState& state, float size) {
  const Palette& colors = palette();
  const bool hovered = state.enabled && state.hovered;
  fill(ctx, rect, state.on ? colors.selected : hovered ? colors.hover : colors.row, 4);
  frame(ctx, rect, state.focused ? colors.accent : colors.border);
  text(ctx, rect.inset(2), label, state.enabled ? colors.text : colors.disabled_text, size,
       Align::Center);
}

void tab(NVGcontext* ctx, const ScreenRect& rect, const ScreenRect& text, const std::string& title,
         bool active, bool hovered, Align align) {
  const Palette& colors = palette();
  fill(ctx, rect, active ? colors.panel : hovered ? colors.hover : colors.window, 3);
  if (active) fill(ctx, {rect.left, rect.top, rect.width, 2}, colors.accent);
  draw::text(ctx, text, title, active ? colors.text : colors.faint_text, kTextSize, align);
}

void row(NVGcontext* ctx, const ScreenRect& rect, std::size_t index, bool selected, bool hovered) {
  const Palette& colors = palette();
  fill(ctx, rect,
       selected         ? colors.selected
       : hovered        ? colors.hover
       : index % 2 == 0 ? colors.panel
                        : colors.row);
}

void text(NVGcontext* ctx, const ScreenRect& rect, const std::string& text, const Color& color,
          float size, Align align, bool bold) {
  const std::string shown = elided(ctx, text, rect.width, size, bold);
  use_font(ctx, size, bold);
  nvgFillColor(ctx, draw::nvg(color));
  const int across = align == Align::Left     ? NVG_ALIGN_LEFT
                     : align == Align::Center ? NVG_ALIGN_CENTER
                                              : NVG_ALIGN_RIGHT;
  const double x = align == Align::Left     ? rect.left
                   : align == Align::Center ? rect.left + 0.5 * rect.width
                                            : rect.left + rect.width;
  nvgTextAlign(ctx, across | NVG_ALIGN_MIDDLE);
  nvgText(ctx, static_cast<float>(x), static_cast<float>(rect.top + 0.5 * rect.height),
          shown.c_str(), nullptr);
}

double wrapped_text(NVGcontext* ctx, const ScreenRect& rect, const std::string& text,
                    const Color& color, float size) {
  use_font(ctx, size, false);
  nvgFillColor(ctx, draw::nvg(color));
  nvgTextAlign(ctx, NVG_ALIGN_LEFT | NVG_ALIGN_TOP);
  const auto left = static_cast<float>(rect.left), top = static_cast<float>(rect.top),
             width = static_cast<float>(rect.width);
  nvgTextBox(ctx, left, top, width, text.c_str(), nullptr);
  return wrapped_height(ctx, text, rect.width, size);
}

double wrapped_height(NVGcontext* ctx, const std::string& text, double width, float size) {
  use_font(ctx, size, false);
  nvgTextAlign(ctx, NVG_ALIGN_LEFT | NVG_ALIGN_TOP);
  float bounds[4];
  nvgTextBoxBounds(ctx, 0, 0, static_cast<float>(width), text.c_str(), nullptr, bounds);
  return bounds[3] - bounds[1];
}

void two_columns(NVGcontext* ctx, const ScreenRect& rect, const std::string& text,
                 const Color& color) {
  const std::vector<std::string> lines = split(text, '\n');
  double first = 0;
  for (const std::string& line : lines)
    if (const std::size_t tab = line.find('\t'); tab != std::string::npos)
      first = std::max(first, text_width(ctx, line.substr(0, tab)));
  double top = rect.top;
  for (const std::string& line : lines) {
    const std::size_t tab = line.find('\t');
    draw::text(ctx, {rect.left, top, rect.width, kColumnsPitch}, line.substr(0, tab), color,
               kTextSize, Align::Left, tab == std::string::npos);
    if (tab != std::string::npos)
      draw::text(
          ctx,
          {rect.left + first + kColumnGap, top, rect.width - first - kColumnGap, kColumnsPitch},
          line.substr(tab + 1), color);
    top += kColumnsPitch;
  }
}

double two_columns_height(const std::string& text) {
  return kColumnsPitch * static_cast<double>(split(text, '\n').size());
}

double text_width(NVGcontext* ctx, const std::string& text, float size, bool bold) {
  use_font(ctx, size, bold);
  return nvgTextBounds(ctx, 0, 0, text.c_str(), nullptr, nullptr);
}

std::string elided(NVGcontext* ctx, const std::string& text, double width, float size, bool bold) {
  return elided(
      text, [&](const std::string& shown) { return text_width(ctx, shown, size, bold) <= width; });
}

std::string elided(const std::string& text,
                   const std::function<bool(const std::string& shown)>& fits) {
  if (fits(text)) return text;
  std::size_t good = 0, bad = text.size();
  while (good + 1 < bad) {
    const std::size_t middle = (good + bad) / 2;
    (fits(text.substr(0, middle) + "…") ? good : bad) = middle;
  }
  while (good > 0 && is_continuation_byte(text[good])) --good;
  return good == 0 ? "" : text.substr(0, good) + "…";
}

}  // namespace slalom::draw
