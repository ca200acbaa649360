#include <slalom/gui/drawing.h>
#include <slalom/gui/menu_bar.h>
#include <slalom/gui/palette.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr double kLineHeight = 26, kHintHeight = 40, kWidth = 400, kMargin = 12, kCheckWidth = 18;

}  // namespace

MenuPopup::MenuPopup(nanogui::Widget* parent, const Actions& actions, Choose choose)
    : Element(parent, "popup"), actions_(actions), choose_(std::move(choose)) {
  setVisible(false);
}

void MenuPopup::open(const std::string& menu, int left, int top) {
  menu_ = menu;
  lines_ = actions_.of_menu(menu);
  current_ = 0;
  setPosition({left, top});
  setSize({static_cast<int>(kWidth),
           static_cast<int>(kLineHeight * static_cast<double>(lines_.size()) + kHintHeight + 8)});
  setVisible(true);
}

ScreenRect MenuPopup::line_rect(std::size_t index) const {
  return {4, 4 + kLineHeight * static_cast<double>(index), kWidth - 8, kLineHeight};
}

std::string MenuPopup::text() const {
  std::string all;
  for (const Action* action : lines_) {
    const std::string why = action->why_not();
    all += action->label() + (why.empty() ? "" : " (" + why + ")") + "\n";
  }
  return all;
}

std::optional<ScreenRect> MenuPopup::rect_of(const std::string& part) const {
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (lines_[i]->id == part) return line_rect(i);
  return Element::rect_of(part);
}

void MenuPopup::draw_line(NVGcontext* ctx, std::size_t index) const {
  const Action& action = *lines_[index];
  const Palette& colors = palette();
  const ScreenRect rect = line_rect(index);
  const bool possible = action.why_not().empty();
  const nanogui::Color& color = possible ? colors.text : colors.disabled_text;
  if (index == current_) draw::fill(ctx, rect, possible ? colors.selected : colors.hover, 3);
  const bool checked = action.checked && action.checked();
  if (checked)
    draw::text(ctx, {rect.left + 6, rect.top, kCheckWidth, rect.height}, "✓", colors.accent);
  const double left = rect.left + kMargin + kCheckWidth - 6;
  draw::text(ctx, {left, rect.top, rect.width - 110 - kCheckWidth, rect.height}, action.label(),
             color);
  draw::text(ctx, {rect.left + rect.width - 110, rect.top, 104, rect.height}, action.shortcut,
             colors.faint_text, draw::kSmallTextSize, draw::Align::Right);
}

void MenuPopup::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  const ScreenRect all = *Element::rect_of("");
  draw::fill(ctx, all, palette().panel, 4);
  draw::frame(ctx, all, palette().border);
  for (std::size_t i = 0; i < lines_.size(); ++i) draw_line(ctx, i);
  if (current_ < lines_.size()) {
    const std::string why = lines_[current_]->why_not();
    const ScreenRect hint = {kMargin, all.height - kHintHeight, all.width - 2 * kMargin,
                             kHintHeight};
    draw::line(ctx, 8, hint.top, all.width - 8, hint.top, palette().border);
    draw::wrapped_text(ctx, {hint.left, hint.top + 5, hint.width, hint.height},
                       why.empty() ? lines_[current_]->help : "Not now: " + why,
                       why.empty() ? palette().faint_text : palette().error_text,
                       draw::kSmallTextSize);
  }
  nvgRestore(ctx);
}

std::optional<std::size_t> MenuPopup::line_at(const nanogui::Vector2i& p) const {
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (line_rect(i).contains(p.x() - mPos.x(), p.y() - mPos.y())) return i;
  return std::nullopt;
}

bool MenuPopup::mouseButtonEvent(const nanogui::Vector2i& p, int, bool down, int) {
  const auto line = line_at(p);
  if (down && line) choose(*line);
  return true;
}

bool MenuPopup::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i&, int, int) {
  if (const auto line = line_at(p)) current_ = *line;
  return true;
}

void MenuPopup::move_choice(int by) {
  const int count = static_cast<int>(lines_.size());
  if (count > 0)
    current_ = static_cast<std::size_t>((static_cast<int>(current_) + by + count) % count);
}

void MenuPopup::choose_current() {
  if (current_ < lines_.size()) choose(current_);
}

void MenuPopup::choose(std::size_t index) {
  if (!lines_[index]->why_not().empty()) {
    current_ = index;
    return;
  }
  close();
  choose_(lines_[index]->id);
}

MenuBar::MenuBar(nanogui::Widget* parent, const Actions& actions, MenuPopup& popup)
    : Element(parent, "menu"), menus_(actions.menus()), popup_(popup) {
  rects_.resize(menus_.size());
}

std::string MenuBar::text() const {
  std::string all;
  for (const std::string& menu : menus_) all += menu + "\n";
  return all;
}

std::optional<ScreenRect> MenuBar::rect_of(const std::string& part) const {
  for (std::size_t i = 0; i < menus_.size(); ++i)
    if (menus_[i] == part) return rects_[i];
  return Element::rect_of(part);
}

void MenuBar::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  draw::fill(ctx, *Element::rect_of(""), palette().panel);
  double left = 4;
  for (std::size_t i = 0; i < menus_.size(); ++i) {
    rects_[i] = {left, 0, draw::text_width(ctx, menus_[i]) + 2 * kMargin,
                 static_cast<double>(height())};
    if (popup_.visible() && popup_.menu() == menus_[i])
      draw::fill(ctx, rects_[i], palette().selected, 3);
    draw::text(ctx, rects_[i], menus_[i], palette().text, draw::kTextSize, draw::Align::Center);
    left += rects_[i].width;
  }
  nvgRestore(ctx);
}

void MenuBar::open(std::size_t index) {
  popup_.open(menus_[index], mPos.x() + static_cast<int>(rects_[index].left), mPos.y() + height());
}

void MenuBar::open_beside(int by) {
  const auto found = std::find(menus_.begin(), menus_.end(), popup_.menu());
  const int count = static_cast<int>(menus_.size());
  if (found != menus_.end())
    open(static_cast<std::size_t>((static_cast<int>(found - menus_.begin()) + by + count) % count));
}

bool MenuBar::mouseButtonEvent(const nanogui::Vector2i& p, int, bool down, int) {
  if (!down) return true;
  for (std::size_t i = 0; i < rects_.size(); ++i) {
    if (!rects_[i].contains(p.x() - mPos.x(), p.y() - mPos.y())) continue;
    if (popup_.visible() && popup_.menu() == menus_[i])
      popup_.close();
    else
      open(i);
  }
  return true;
}

bool MenuBar::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i&, int, int) {
  if (!popup_.visible()) return false;
  for (std::size_t i = 0; i < rects_.size(); ++i)
    if (rects_[i].contains(p.x() - mPos.x(), p.y() - mPos.y()) && popup_.menu() != menus_[i])
      open(i);
  return true;
}

}  // namespace slalom
