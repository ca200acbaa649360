#include "widgets/drawing.h"
#include "widgets/menu_bar.h"

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

constexpr double kMenuWidth = 400, kTitleMargin = 12;  ///< pixels

}  // namespace

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
  std::vector<MenuLine> lines;
  for (const Action* action : actions_.of_menu(menu))
    lines.push_back({action->id, action->label(), action->shortcut, action->help,
                     action->disabled_reason(), action->checked && action->checked()});
  popup_->open({mPos.x() + rect_of(menu)->left, static_cast<double>(mPos.y() + height())},
               kMenuWidth, parent()->height(), lines, 0,
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
  if (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT)
    return open_adjacent(key == GLFW_KEY_LEFT ? -1 : 1), true;
  if (popup_->key(key, modifiers)) return true;
  popup_->close();
  return false;
}

bool MenuBar::press(const Point& at, int /*modifiers*/) {
  const std::string menu = part_at(at);
  if (popup_->visible() && menu == open_menu_)
    popup_->close();
  else if (!menu.empty())
    open(menu);
  return true;
}

void MenuBar::hover(const std::optional<Point>& at) {
  const std::string menu = at && popup_->visible() ? part_at(*at) : "";
  if (!menu.empty() && menu != open_menu_) open(menu);
}

}  // namespace slalom
