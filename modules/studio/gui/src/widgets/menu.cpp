// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/drawing.h"
#include "widgets/menu.h"

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

constexpr double kLineHeight = 25, kMenuBorder = 3, kMenuHelpHeight = 42;  ///< pixels
constexpr double kMenuMargin = 8, kCheckWidth = 18, kShortcutWidth = 104;

bool has_help(const std::vector<MenuLine>& lines) {
  return !lines.empty() && !lines.front().help.empty();
}

constexpr double kMenuWidth = 400, kTitleMargin = 12;  ///< pixels

}  // namespace

MenuLine menu_line(const Action& action) {
  return {action.id,   action.label(),        action.shortcut,
          action.help, action.disabled_check, action.checked && action.checked()};
}

Menu::Menu(nanogui::Widget* parent, const std::string& id, nanogui::Widget* focus_after)
    : Table(parent, id, {kMenuBorder, kLineHeight, kMenuBorder}), focus_after_(focus_after) {
  setVisible(false);
}

void Menu::open(const Point& corner, double width, double bottom, std::vector<MenuLine> lines,
                std::size_t current, Chosen chosen) {
  lines_ = std::move(lines);
  current_ = std::min(current, lines_.empty() ? 0 : lines_.size() - 1);
  chosen_ = std::move(chosen);
  set_footer(has_help(lines_) ? kMenuHelpHeight : kMenuBorder);
  const double preferred =
      kMenuBorder + kLineHeight * static_cast<double>(lines_.size()) + heights().footer;
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
    const std::string reason = lines_[i].disabled_reason();
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

void Menu::paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) {
  const MenuLine& line = lines_[row];
  const Palette& colors = palette();
  const bool enabled = line.disabled_reason().empty(), has_shortcuts = has_help(lines_);
  if (row == current_)
    draw::fill(ctx, rect.inset(kMenuBorder), enabled ? colors.selected : colors.hover, 3);
  ScreenRect text = rect.inset(kMenuMargin);
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
  const double top = height() - kMenuHelpHeight;
  draw::line(ctx, kMenuMargin, top, width() - kMenuMargin, top, palette().border);
  const std::string reason = line.disabled_reason();
  const bool enabled = reason.empty();
  draw::wrapped_text(ctx, {kMenuMargin, top + 5, width() - 2 * kMenuMargin, kMenuHelpHeight},
                     enabled ? line.help : "Unavailable: " + reason,
                     enabled ? palette().faint_text : palette().error_text, draw::kSmallTextSize);
}

void Menu::hover(const std::optional<Point>& at) {
  Table::hover(at);
  current_ = hovered().value_or(current_);
}

void Menu::choose(std::size_t row, int /*modifiers*/) {
  current_ = row;
  if (!lines_[row].disabled_reason().empty()) return;
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
    choose(current_, 0);
    return true;
  }
  if (key == GLFW_KEY_UP && current_ == 0)
    key = GLFW_KEY_END;
  else if (key == GLFW_KEY_DOWN && current_ + 1 == lines_.size())
    key = GLFW_KEY_HOME;
  return modifiers == 0 && Table::key(key, 0);
}

MenuBar::MenuBar(nanogui::Widget* parent, const Actions& actions, Run run)
    : Element(parent, "menu"),
      actions_(actions),
      run_(std::move(run)),
      popup_(new Menu(parent, "popup")) {
  for (const std::string& menu : actions.menus()) parts_.push_back({menu, {}});
}

std::string MenuBar::text() const {
  std::string all;
  for (const Part& menu : parts_) all += menu.name + "\n";
  return all;
}

void MenuBar::paint(NVGcontext* ctx) {
  draw::fill(ctx, area(), palette().panel);
  double left = 4;
  for (auto& [name, rect] : parts_) {
    rect = {left, 0, draw::text_width(ctx, name) + 2 * kTitleMargin, area().height};
    if (popup_->visible() && open_menu_ == name) draw::fill(ctx, rect, palette().selected, 3);
    draw::text(ctx, rect, name, palette().text, draw::kTextSize, draw::Align::Center);
    left = rect.right();
  }
}

void MenuBar::open(const std::string& menu) {
  open_menu_ = menu;
  open_lines({mPos.x() + rect_of(menu)->left, static_cast<double>(mPos.y() + height())},
             actions_.of_menu(menu));
}

void MenuBar::open_context(const Point& at, const std::vector<std::string>& ids) {
  open_menu_.clear();
  std::vector<const Action*> actions;
  for (const std::string& id : ids) actions.push_back(&actions_.find(id));
  const double tall = kMenuBorder + kLineHeight * static_cast<double>(ids.size()) + kMenuHelpHeight;
  open_lines({std::clamp<double>(parent()->width() - kMenuWidth, 0, at.x),
              std::clamp<double>(parent()->height() - tall, 0, at.y)},
             actions);
}

void MenuBar::open_lines(const Point& corner, const std::vector<const Action*>& actions) {
  std::vector<MenuLine> lines;
  for (const Action* action : actions) lines.push_back(menu_line(*action));
  popup_->open(corner, kMenuWidth, parent()->height(), lines, 0,
               [this, lines](std::size_t line) { run_(lines[line].name); });
}

void MenuBar::open_adjacent(int by) {
  const auto now = std::find_if(parts_.begin(), parts_.end(),
                                [this](const Part& part) { return part.name == open_menu_; });
  const auto count = static_cast<std::ptrdiff_t>(parts_.size());
  open(parts_[static_cast<std::size_t>((now - parts_.begin() + by + count) % count)].name);
}

bool MenuBar::popup_key(int key, int modifiers) {
  if (!popup_->visible()) return false;
  if (!open_menu_.empty() && (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT))
    return open_adjacent(key == GLFW_KEY_LEFT ? -1 : 1), true;
  if (popup_->key(key, modifiers)) return true;
  popup_->close();
  return false;
}

void MenuBar::click(const std::string& menu) {
  if (popup_->visible() && menu == open_menu_)
    popup_->close();
  else if (!menu.empty())
    open(menu);
}

void MenuBar::hover(const std::optional<Point>& at) {
  const bool menu_open = popup_->visible() && !open_menu_.empty();
  const std::string menu = at && menu_open ? part_at(*at) : "";
  if (!menu.empty() && menu != open_menu_) open(menu);
}

}  // namespace slalom
