#include <slalom/gui/drawing.h>
#include <slalom/gui/list_panel.h>
#include <slalom/gui/palette.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kMargin = 6, kControl = 28, kTabs = 32, kFoot = 26;
constexpr double kLeastTab = 90, kMostTab = 200, kClose = 22;
constexpr double kLongestMessage = 80;  // pixels high
constexpr float kMessageSize = draw::kSmallTextSize + 1;

/// `text`, or its beginning with "…" that takes no more lines than there is room for.
std::string fitting(NVGcontext* ctx, const std::string& text, double width) {
  nvgFontFace(ctx, "sans");
  nvgFontSize(ctx, kMessageSize);
  nvgTextAlign(ctx, NVG_ALIGN_LEFT | NVG_ALIGN_TOP);
  return draw::shortened(text, [&](const std::string& shown) {
    float bounds[4];
    nvgTextBoxBounds(ctx, 0, 0, static_cast<float>(width), shown.c_str(), nullptr, bounds);
    return bounds[3] - bounds[1] <= kLongestMessage;
  });
}

double controls_top(double message_height) {
  return kTabs + kMargin + kControl + kMargin + message_height;
}

}  // namespace

std::size_t ListPanel::tabs_seen() const {
  return static_cast<std::size_t>(std::max((width() - kMargin) / kLeastTab, 1.0));
}

std::optional<ScreenRect> ListPanel::tab_rect(std::size_t tab) const {
  const std::size_t seen = std::min(tabs_seen(), documents_.size());
  if (tab < first_tab_ || tab >= first_tab_ + seen) return std::nullopt;
  const double wide =
      std::min(std::floor((width() - kMargin) / static_cast<double>(seen)), kMostTab);
  return ScreenRect{kMargin + static_cast<double>(tab - first_tab_) * wide, 4, wide - 4, kTabs - 4};
}

std::optional<ScreenRect> ListPanel::rect_of(const std::string& part) const {
  const bool closes = part.rfind("close ", 0) == 0;
  if (closes || part.rfind("tab ", 0) == 0) {
    const std::string number = part.substr(part.find(' ') + 1);
    for (std::size_t tab = 0; tab < documents_.size(); ++tab) {
      if (number != std::to_string(tab)) continue;
      first_tab_ = std::min(std::max(first_tab_, tab + 1 - std::min(tab + 1, tabs_seen())), tab);
      const ScreenRect rect = *tab_rect(tab);
      return closes ? ScreenRect{rect.left + rect.width - kClose, rect.top, kClose, rect.height}
                    : rect;
    }
    return std::nullopt;
  }
  const double top = controls_top(message_height_), room = width() - 2 * kMargin;
  const double sort = std::floor(0.52 * (room - kControl - 8));
  if (part == "sort") return ScreenRect{kMargin, top, sort, kControl};
  if (part == "direction") return ScreenRect{kMargin + sort + 4, top, kControl, kControl};
  const double group = kMargin + sort + kControl + 8;
  if (part == "group_by") return ScreenRect{group, top, width() - kMargin - group, kControl};
  if (part.empty()) return Element::rect_of(part);
  const nanogui::Widget* owner = rows_;
  auto rect = rows_->rect_of(part);
  if (!rect) {
    owner = choices_;
    rect = choices_->rect_of(part);
  }
  if (rect) {
    rect->left += owner->position().x();
    rect->top += owner->position().y();
  }
  return rect;
}

/// Those on others first.
std::vector<std::string> ListPanel::shown_parts() const {
  std::vector<std::string> parts;
  for (std::size_t tab = first_tab_; tab < documents_.size() && tab_rect(tab); ++tab) {
    parts.push_back("close " + std::to_string(tab));
    parts.push_back("tab " + std::to_string(tab));
  }
  for (const char* control : {"sort", "direction", "group_by"}) parts.emplace_back(control);
  return parts;
}

void ListPanel::performLayout(NVGcontext* ctx) {
  Element::performLayout(ctx);
  if (filter_->theme() == theme() && theme() != nullptr) {
    // The theme's own colour of what may be typed is too faint to read.
    nanogui::ref<nanogui::Theme> readable = new nanogui::Theme(*theme());
    readable->mDisabledTextColor = palette().faint_text;
    filter_->setTheme(readable);
    filter_->setFontSize(15);  // which setTheme() undid
  }
  arrange();
}

void ListPanel::arrange() {
  const int margin = static_cast<int>(kMargin);
  filter_->setPosition({margin, static_cast<int>(kTabs + kMargin)});
  filter_->setSize({std::max(width() - 2 * margin, 1), static_cast<int>(kControl)});
  const double top = controls_top(message_height_) + kControl + kMargin;
  rows_->setPosition({0, static_cast<int>(top)});
  rows_->setSize({width(), std::max(static_cast<int>(height() - kFoot - top), 0)});
}

void ListPanel::draw(NVGcontext* ctx) {
  const Palette& colors = palette();
  if (document() != nullptr && document()->filter_text() != filter_shown_) {
    filter_shown_ = document()->filter_text();
    if (!filter_->focused()) filter_->setValue(filter_shown_);
  }
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  draw::fill(ctx, *Element::rect_of(""), colors.panel);
  draw::fill(ctx, {0, 0, static_cast<double>(width()), kTabs}, colors.window);
  for (std::size_t tab = first_tab_; tab < documents_.size() && tab_rect(tab); ++tab)
    draw_tab(ctx, tab);
  const double message_height = draw_message(ctx);
  if (message_height != message_height_) {
    message_height_ = message_height;
    arrange();
  }
  draw_control(ctx, "sort", "Sort: " + sort_text());
  draw_direction(ctx);
  draw_control(ctx, "group_by", group_text());
  const double foot_top = height() - kFoot;
  draw::line(ctx, 0, foot_top + 0.5, width(), foot_top + 0.5, colors.border);
  draw::text(ctx, {kMargin, foot_top, width() - 2 * kMargin, kFoot}, foot(), colors.faint_text,
             draw::kSmallTextSize + 1);
  nvgRestore(ctx);
  Element::draw(ctx);
}

double ListPanel::draw_message(NVGcontext* ctx) {
  if (message().empty()) return 0;
  const double wide = width() - 2 * kMargin;
  if (message() != message_ || wide != message_width_) {
    message_ = message();
    message_width_ = wide;
    message_shown_ = fitting(ctx, message_, wide);
  }
  const bool error = !document()->filter_error().empty();
  return std::ceil(draw::wrapped_text(ctx, message_rect(), message_shown_,
                                      error ? palette().error_text : palette().faint_text,
                                      kMessageSize)) +
         4;
}

ScreenRect ListPanel::message_rect() const {
  return ScreenRect{kMargin, kTabs + kMargin + kControl + 4, width() - 2 * kMargin,
                    message_height_};
}

void ListPanel::draw_tab(NVGcontext* ctx, std::size_t tab) const {
  const Palette& colors = palette();
  const std::string number = std::to_string(tab);
  const ScreenRect rect = *tab_rect(tab), close = *rect_of("close " + number);
  const bool active = tab == active_, hovered = hovered_ == "tab " + number;
  draw::fill(ctx, rect, active ? colors.panel : hovered ? colors.hover : colors.row, 3);
  if (active) draw::fill(ctx, {rect.left, rect.top, rect.width, 2}, colors.accent);
  draw::text(ctx, {rect.left + 8, rect.top, rect.width - kClose - 10, rect.height},
             documents_[tab]->title(), active ? colors.text : colors.faint_text);
  const double x = close.left + 0.5 * close.width, y = close.top + 0.5 * close.height;
  const nanogui::Color ink = hovered_ == "close " + number ? colors.error_text : colors.faint_text;
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
  const auto x = static_cast<float>(rect.left + rect.width - 12),
             y = static_cast<float>(rect.top + 0.5 * rect.height);
  nvgBeginPath(ctx);
  nvgMoveTo(ctx, x - 5, y - 2);
  nvgLineTo(ctx, x + 5, y - 2);
  nvgLineTo(ctx, x, y + 4);
  nvgFillColor(ctx, colors.faint_text);
  nvgFill(ctx);
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
