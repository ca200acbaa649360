#pragma once

#include <slalom/gui/element.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// What elements draw with: thin words for NanoVG's calls. Sizes in pixels.
namespace draw {

constexpr float kTextSize = 15, kSmallTextSize = 13;

enum class Align { Left, Center, Right };

void fill(NVGcontext* ctx, const ScreenRect& rect, const nanogui::Color& color, float radius = 0);
void frame(NVGcontext* ctx, const ScreenRect& rect, const nanogui::Color& color);
void line(NVGcontext* ctx, double x0, double y0, double x1, double y1, const nanogui::Color& color,
          float width = 1);

/// In the middle of the height of `rect`; shortened with an ellipsis where it is too long.
void text(NVGcontext* ctx, const ScreenRect& rect, const std::string& text,
          const nanogui::Color& color, float size = kTextSize, Align align = Align::Left,
          bool bold = false);
/// Over several lines from the top of `rect`; returns the height that it takes.
double wrapped_text(NVGcontext* ctx, const ScreenRect& rect, const std::string& text,
                    const nanogui::Color& color, float size = kTextSize);
double text_width(NVGcontext* ctx, const std::string& text, float size = kTextSize,
                  bool bold = false);
/// `text`, or its beginning with "…" that fits into `width`.
std::string shortened(NVGcontext* ctx, const std::string& text, double width,
                      float size = kTextSize, bool bold = false);
/// The same for any other measure of what fits.
std::string shortened(const std::string& text,
                      const std::function<bool(const std::string& shown)>& fits);

}  // namespace draw
}  // namespace slalom
