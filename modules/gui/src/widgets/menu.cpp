#include "widgets/drawing.h"
#include "widgets/menu.h"

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

constexpr double kLineHeight = 25, kBorder = 3, kHelpHeight = 42;  ///< pixels
constexpr double kMargin = 8, kCheckWidth = 18, kShortcutWidth = 104;

bool has_help(const std::vector<MenuLine>& lines) {
  return !lines.empty() && !lines.front().help.empty();
}

}  // namespace

Menu::Menu(nanogui::Widget* parent, const std::string& id, nanogui::Widget* focus_after)
    : Table(parent, id, {kBorder, kLineHeight, kBorder}), focus_after_(focus_after) {
  setVisible(false);
}

void Menu::open(const Point& corner, double width, double bottom, std::vector<MenuLine> lines,
                std::size_t current, Chosen chosen) {
  lines_ = std::move(lines);
  current_ = std::min(current, lines_.empty() ? 0 : lines_.size() - 1);
  chosen_ = std::move(chosen);
  set_footer(has_help(lines_) ? kHelpHeight : kBorder);
  const double preferred =
      kBorder + kLineHeight * static_cast<double>(lines_.size()) + heights().footer;
  set_bounds({corner.x, corner.y, width,
              std::clamp(bottom - corner.y, std::min(2 * kLineHeight, preferred), preferred)});
  if (!lines_.empty()) bring_into_view(current_);
  setVisible(true);
  if (focus_after_ != nullptr) requestFocus();
}

void Menu::close() {
  const bool had_focus = visible() && focused();
  setVisible(false);
  if (had_focus) focus_after_->requestFocus();
}

bool Menu::focusEvent(bool focused) {
  if (!focused) setVisible(false);
  return Table::focusEvent(focused);
}

std::string Menu::text() const {
  std::string all;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const std::string& reason = lines_[i].disabled_reason;
    all += (i == current_ ? "> " : "") + lines_[i].text +
           (reason.empty() ? "" : " (" + reason + ")") + "\n";
  }
  return all;
}

std::optional<ScreenRect> Menu::rect_of(const std::string& part) const {
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (lines_[i].name == part) return bring_into_view(i);
  return Table::rect_of(part);
}

void Menu::paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) const {
  const MenuLine& line = lines_[row];
  const Palette& colors = palette();
  const bool enabled = line.disabled_reason.empty(), has_shortcuts = has_help(lines_);
  if (row == current_)
    draw::fill(ctx, rect.inset(kBorder), enabled ? colors.selected : colors.hover, 3);
  ScreenRect text = rect.inset(kMargin);
  if (has_shortcuts) {
    if (line.checked)
      draw::check_mark(ctx, {rect.left + 2, rect.top, kCheckWidth, rect.height}, colors.accent);
    draw::text(ctx, {text.right() - kShortcutWidth, rect.top, kShortcutWidth, rect.height},
               line.shortcut, colors.faint_text, draw::kSmallTextSize, draw::Align::Right);
    text = {rect.left + kCheckWidth, rect.top, text.width - kCheckWidth - kShortcutWidth,
            rect.height};
  }
  draw::text(ctx, text, line.text, enabled ? colors.text : colors.disabled_text);
}

void Menu::paint_frame(NVGcontext* ctx) const {
  draw::frame(ctx, area(), focus_after_ != nullptr ? palette().accent : palette().border);
  if (!has_help(lines_)) return;
  const MenuLine& line = lines_[current_];
  const double top = height() - kHelpHeight;
  draw::line(ctx, kMargin, top, width() - kMargin, top, palette().border);
  const bool enabled = line.disabled_reason.empty();
  draw::wrapped_text(ctx, {kMargin, top + 5, width() - 2 * kMargin, kHelpHeight},
                     enabled ? line.help : "Unavailable: " + line.disabled_reason,
                     enabled ? palette().faint_text : palette().error_text, draw::kSmallTextSize);
}

void Menu::hover(const std::optional<Point>& at) {
  Table::hover(at);
  current_ = hovered().value_or(current_);
}

void Menu::choose(std::size_t row) {
  current_ = row;
  if (!lines_[row].disabled_reason.empty()) return;
  const Chosen chosen = chosen_;
  close();
  chosen(row);
}

bool Menu::key(int key, int modifiers) {
  if (key == GLFW_KEY_ESCAPE) {
    close();
    return true;
  }
  if (lines_.empty()) return false;
  if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) {
    choose(current_);
    return true;
  }
  if (key == GLFW_KEY_UP && current_ == 0)
    key = GLFW_KEY_END;
  else if (key == GLFW_KEY_DOWN && current_ + 1 == lines_.size())
    key = GLFW_KEY_HOME;
  return Table::key(key, modifiers);
}

}  // namespace slalom
