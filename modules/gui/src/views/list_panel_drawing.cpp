#include "views/list_panel.h"
#include "widgets/drawing.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kListMargin = 6, kControlHeight = 28, kTabBarHeight = 32, kFooterHeight = 26;
constexpr double kMinTabWidth = 90, kMaxTabWidth = 200, kCloseWidth = 22;
constexpr double kMaxMessageHeight = 80;  // pixels
constexpr float kMessageSize = draw::kSmallTextSize + 1;

/// Returns `text`, or its beginning and "…" so that it is at most kMaxMessageHeight high.
std::string elided_message(NVGcontext* ctx, const std::string& text, double width) {
  return draw::elided(text, [&](const std::string& shown) {
    return draw::wrapped_height(ctx, shown, width, kMessageSize) <= kMaxMessageHeight;
  });
}

double controls_top(double message_height) {
  return kTabBarHeight + kListMargin + kControlHeight + kListMargin + message_height;
}

}  // namespace

std::size_t ListPanel::visible_tab_count() const {
  return static_cast<std::size_t>(std::max((width() - kListMargin) / kMinTabWidth, 1.0));
}

void ListPanel::show_tab(std::size_t tab) const {
  first_tab_ =
      std::min(std::max(first_tab_, tab + 1 - std::min(tab + 1, visible_tab_count())), tab);
}

/// Scrolls to a tab.
std::optional<ScreenRect> ListPanel::rect_of(const std::string& part) const {
  for (std::size_t tab = 0; tab < studio_.documents().size(); ++tab)
    if (part == "tab " + std::to_string(tab) || part == "close " + std::to_string(tab))
      show_tab(tab);
  return Element::rect_of(part);
}

std::vector<Element::Part> ListPanel::parts() const {
  std::vector<Part> all;
  const std::size_t tabs = studio_.documents().size();
  const std::size_t visible = std::max<std::size_t>(std::min(visible_tab_count(), tabs), 1);
  const double tab_width =
      std::min(std::floor((width() - kListMargin) / static_cast<double>(visible)), kMaxTabWidth);
  double left = kListMargin;
  for (std::size_t tab = first_tab_; tab < std::min(tabs, first_tab_ + visible); ++tab) {
    const ScreenRect rect{left, 4, tab_width - 4, kTabBarHeight - 4};
    all.push_back({"close " + std::to_string(tab),
                   {rect.right() - kCloseWidth, rect.top, kCloseWidth, rect.height}});
    all.push_back({"tab " + std::to_string(tab), rect});
    left += tab_width;
  }
  const double top = controls_top(message_height_), available = width() - 2 * kListMargin;
  const double sort = std::floor(0.52 * (available - kControlHeight - 8));
  const double direction = kListMargin + sort + 4, group = direction + kControlHeight + 4;
  all.push_back({"sort", {kListMargin, top, sort, kControlHeight}});
  all.push_back({"direction", {direction, top, kControlHeight, kControlHeight}});
  all.push_back({"group_by", {group, top, width() - kListMargin - group, kControlHeight}});
  return all;
}

void ListPanel::performLayout(NVGcontext* ctx) {
  Element::performLayout(ctx);
  if (filter_->theme() == theme() && theme() != nullptr) {
    // The placeholder color of the theme has too little contrast.
    nanogui::ref<nanogui::Theme> readable = new nanogui::Theme(*theme());
    readable->mDisabledTextColor = draw::nvg(palette().faint_text);
    filter_->setTheme(readable);
    filter_->setFontSize(15);  // setTheme() resets it
  }
  arrange();
}

void ListPanel::arrange() {
  const int margin = static_cast<int>(kListMargin);
  filter_->setPosition({margin, static_cast<int>(kTabBarHeight + kListMargin)});
  filter_->setSize({std::max(width() - 2 * margin, 1), static_cast<int>(kControlHeight)});
  const double top = controls_top(message_height_) + kControlHeight + kListMargin;
  rows_->set_bounds({0, top, area().width, height() - kFooterHeight - top});
}

void ListPanel::paint(NVGcontext* ctx) {
  const Palette& colors = palette();
  if (document() != nullptr && document()->filter_text() != shown_filter_) {
    shown_filter_ = document()->filter_text();
    if (!filter_->focused()) filter_->setValue(shown_filter_);
  }
  draw::fill(ctx, area(), colors.panel);
  draw::fill(ctx, {0, 0, area().width, kTabBarHeight}, colors.window);
  for (std::size_t tab = 0; tab < studio_.documents().size(); ++tab) draw_tab(ctx, tab);
  const double message_height = draw_message(ctx);
  if (message_height != message_height_) {
    message_height_ = message_height;
    arrange();
  }
  draw_control(ctx, "sort", "Sort: " + sort_text());
  draw_direction(ctx);
  draw_control(ctx, "group_by", group_text());
  const double footer_top = height() - kFooterHeight;
  draw::line(ctx, 0, footer_top + 0.5, width(), footer_top + 0.5, colors.border);
  draw::text(ctx, {kListMargin, footer_top, width() - 2 * kListMargin, kFooterHeight},
             footer_text(), colors.faint_text, draw::kSmallTextSize + 1);
}

double ListPanel::draw_message(NVGcontext* ctx) {
  if (message().empty()) return 0;
  const double text_width = width() - 2 * kListMargin;
  if (message() != message_ || text_width != message_width_) {
    message_ = message();
    message_width_ = text_width;
    elided_message_ = elided_message(ctx, message_, text_width);
  }
  const bool error = !document()->filter_error().empty();
  return std::ceil(draw::wrapped_text(ctx, message_rect(), elided_message_,
                                      error ? palette().error_text : palette().faint_text,
                                      kMessageSize)) +
         4;
}

ScreenRect ListPanel::message_rect() const {
  return ScreenRect{kListMargin, kTabBarHeight + kListMargin + kControlHeight + 4,
                    width() - 2 * kListMargin, message_height_};
}

void ListPanel::draw_tab(NVGcontext* ctx, std::size_t tab) const {
  const std::string number = std::to_string(tab);
  const auto rect = Element::rect_of("tab " + number), close = Element::rect_of("close " + number);
  if (!rect || !close) return;  // scrolled out of view
  draw::tab(ctx, *rect, {rect->left + 8, rect->top, rect->width - kCloseWidth - 10, rect->height},
            studio_.documents()[tab]->title(), tab == studio_.active_index(),
            hovered_ == "tab " + number);
  const double x = close->left + 0.5 * close->width, y = close->top + 0.5 * close->height;
  const Color& ink = hovered_ == "close " + number ? palette().error_text : palette().faint_text;
  draw::line(ctx, x - 4, y - 4, x + 4, y + 4, ink, 1.5F);
  draw::line(ctx, x - 4, y + 4, x + 4, y - 4, ink, 1.5F);
}

void ListPanel::draw_control(NVGcontext* ctx, const std::string& part,
                             const std::string& text) const {
  const Palette& colors = palette();
  const ScreenRect rect = *rect_of(part);
  draw::fill(ctx, rect, hovered_ == part ? colors.hover : colors.window, 3);
  draw::frame(ctx, rect, colors.border);
  draw::text(ctx, {rect.left + 8, rect.top, rect.width - 26, rect.height}, text,
             document() != nullptr ? colors.text : colors.disabled_text);
  const double x = rect.right() - 12, y = rect.top + 0.5 * rect.height;
  draw::triangle(ctx, {x - 5, y - 2}, {x + 5, y - 2}, {x, y + 4}, colors.faint_text);
}

void ListPanel::draw_direction(NVGcontext* ctx) const {
  const Palette& colors = palette();
  const ScreenRect rect = *rect_of("direction");
  draw::fill(ctx, rect, hovered_ == "direction" ? colors.hover : colors.window, 3);
  draw::frame(ctx, rect, colors.border);
  const bool down = document() != nullptr && document()->request().descending;
  const double x = rect.left + 0.5 * rect.width, y = rect.top + 0.5 * rect.height;
  const double tip = down ? y + 8 : y - 8, back = down ? y + 3 : y - 3;
  draw::line(ctx, x, y - 8, x, y + 8, colors.text, 1.5F);
  draw::line(ctx, x - 5, back, x, tip, colors.text, 1.5F);
  draw::line(ctx, x + 5, back, x, tip, colors.text, 1.5F);
}

}  // namespace slalom
