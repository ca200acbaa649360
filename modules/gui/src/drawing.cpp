#include "utf8.h"

#include <slalom/gui/drawing.h>

namespace slalom::draw {
namespace {

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

void fill(NVGcontext* ctx, const ScreenRect& rect, const nanogui::Color& color, float radius) {
  path_of(ctx, rect, radius);
  nvgFillColor(ctx, color);
  nvgFill(ctx);
}

void frame(NVGcontext* ctx, const ScreenRect& rect, const nanogui::Color& color) {
  path_of(ctx, {rect.left + 0.5, rect.top + 0.5, rect.width - 1, rect.height - 1}, 0);
  nvgStrokeColor(ctx, color);
  nvgStrokeWidth(ctx, 1);
  nvgStroke(ctx);
}

void line(NVGcontext* ctx, double x0, double y0, double x1, double y1, const nanogui::Color& color,
          float width) {
  nvgBeginPath(ctx);
  nvgMoveTo(ctx, static_cast<float>(x0), static_cast<float>(y0));
  nvgLineTo(ctx, static_cast<float>(x1), static_cast<float>(y1));
  nvgStrokeColor(ctx, color);
  nvgStrokeWidth(ctx, width);
  nvgStroke(ctx);
}

void text(NVGcontext* ctx, const ScreenRect& rect, const std::string& text,
          const nanogui::Color& color, float size, Align align, bool bold) {
  const std::string shown = shortened(ctx, text, rect.width, size, bold);
  use_font(ctx, size, bold);
  nvgFillColor(ctx, color);
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
                    const nanogui::Color& color, float size) {
  use_font(ctx, size, false);
  nvgFillColor(ctx, color);
  nvgTextAlign(ctx, NVG_ALIGN_LEFT | NVG_ALIGN_TOP);
  const auto left = static_cast<float>(rect.left), top = static_cast<float>(rect.top),
             width = static_cast<float>(rect.width);
  nvgTextBox(ctx, left, top, width, text.c_str(), nullptr);
  float bounds[4];
  nvgTextBoxBounds(ctx, left, top, width, text.c_str(), nullptr, bounds);
  return bounds[3] - bounds[1];
}

double text_width(NVGcontext* ctx, const std::string& text, float size, bool bold) {
  use_font(ctx, size, bold);
  return nvgTextBounds(ctx, 0, 0, text.c_str(), nullptr, nullptr);
}

std::string shortened(NVGcontext* ctx, const std::string& text, double width, float size,
                      bool bold) {
  return shortened(
      text, [&](const std::string& shown) { return text_width(ctx, shown, size, bold) <= width; });
}

std::string shortened(const std::string& text,
                      const std::function<bool(const std::string& shown)>& fits) {
  if (fits(text)) return text;
  std::size_t good = 0, bad = text.size();
  while (good + 1 < bad) {
    const std::size_t middle = (good + bad) / 2;
    (fits(text.substr(0, middle) + "…") ? good : bad) = middle;
  }
  while (good > 0 && continues_letter(text[good])) --good;
  return good == 0 ? "" : text.substr(0, good) + "…";
}

}  // namespace slalom::draw
