#include <slalom/gui/descriptor_panel.h>
#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

using Tab = DescriptorPanel::Tab;

constexpr double kTabs = 27, kChoices = 25;          ///< heights, pixels
constexpr double kTabWide = 88, kArrow = 24;         ///< pixels
constexpr double kChoiceMost = 280, kCompute = 160;  ///< pixels
constexpr std::array<Tab, 3> kAllTabs = {Tab::Values, Tab::Histogram, Tab::Scatter};

std::string title_of(Tab tab) {
  if (tab == Tab::Values) return "Values";
  return tab == Tab::Histogram ? "Histogram" : "Scatter";
}

std::string part_of(Tab tab) {
  if (tab == Tab::Values) return "tab values";
  return tab == Tab::Histogram ? "tab histogram" : "tab scatter";
}

ScreenRect inner(const ScreenRect& rect) {
  return {rect.left + 8, rect.top, std::max(rect.width - 16, 0.0), rect.height};
}

}  // namespace

void DescriptorPanel::performLayout(NVGcontext* /*ctx*/) {
  const int top = static_cast<int>(kTabs), plot = static_cast<int>(kTabs + kChoices);
  table_->setPosition({0, top});
  table_->setSize({width(), std::max(height() - top, 0)});
  for (Element* element : std::initializer_list<Element*>{histogram_, scatter_}) {
    element->setPosition({0, plot});
    element->setSize({width(), std::max(height() - plot, 0)});
  }
}

ScreenRect DescriptorPanel::tab_rect(Tab tab) const {
  const auto place = std::find(kAllTabs.begin(), kAllTabs.end(), tab) - kAllTabs.begin();
  return {static_cast<double>(place) * kTabWide, 0, kTabWide, kTabs};
}

std::vector<std::string> DescriptorPanel::choices() const {
  if (tab_ == Tab::Values) return {};
  if (tab_ == Tab::Histogram) return {"descriptor"};
  return {"x", "y"};
}

std::string DescriptorPanel::name_of_choice(const std::string& choice) const {
  if (choice == "descriptor") return model_.chosen_row().info.name;
  return choice == "x" ? "x: " + info_of(x_).name : "y: " + info_of(y_).name;
}

ScreenRect DescriptorPanel::choice_rect(const std::string& choice) const {
  const double room = (width() - kCompute - 12) / 2;
  const double wide = std::min(room, kChoiceMost);
  return {choice == "y" ? wide : 0, kTabs, wide, kChoices};
}

std::optional<ScreenRect> DescriptorPanel::compute_rect() const {
  if (tab_ == Tab::Values || !list_status_.empty() || missing() == 0) return std::nullopt;
  return ScreenRect{width() - kCompute - 4, kTabs + 2, kCompute, kChoices - 4};
}

std::optional<ScreenRect> DescriptorPanel::own_part(const std::string& part) const {
  for (const Tab tab : kAllTabs)
    if (part == part_of(tab)) return tab_rect(tab);
  for (const std::string& choice : choices()) {
    const ScreenRect rect = choice_rect(choice);
    if (part == choice + " previous") return ScreenRect{rect.left, rect.top, kArrow, rect.height};
    if (part == choice + " next")
      return ScreenRect{rect.left + rect.width - kArrow, rect.top, kArrow, rect.height};
  }
  if (part == "compute") return compute_rect();
  return std::nullopt;
}

std::optional<ScreenRect> DescriptorPanel::rect_of(const std::string& part) const {
  if (part.empty()) return Element::rect_of(part);
  if (const auto own = own_part(part)) return own;
  auto rect = shown()->rect_of(part);
  if (!rect) return std::nullopt;
  rect->left += shown()->position().x();
  rect->top += shown()->position().y();
  return rect;
}

void DescriptorPanel::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  draw_tabs(ctx);
  draw_choices(ctx);
  nvgRestore(ctx);
  Widget::draw(ctx);
}

void DescriptorPanel::draw_tabs(NVGcontext* ctx) const {
  const Palette& colors = palette();
  draw::fill(ctx, {0, 0, static_cast<double>(width()), kTabs}, colors.window);
  for (const Tab tab : kAllTabs) {
    const ScreenRect rect = tab_rect(tab);
    if (tab == tab_) draw::fill(ctx, rect, colors.panel);
    if (tab == tab_) draw::fill(ctx, {rect.left, 0, rect.width, 2}, colors.accent);
    draw::text(ctx, rect, title_of(tab), tab == tab_ ? colors.text : colors.faint_text,
               draw::kTextSize, draw::Align::Center);
  }
  const double left = static_cast<double>(kAllTabs.size()) * kTabWide;
  const ScreenRect rest{left, 0, width() - left, kTabs};
  const bool of_list = model_.status().empty() || tab_ != Tab::Values;
  draw::text(ctx, inner(rest), of_list ? list_status_ : model_.status(),
             !of_list && model_.failed() ? colors.error_text : colors.faint_text,
             draw::kSmallTextSize, draw::Align::Right);
}

void DescriptorPanel::draw_choices(NVGcontext* ctx) const {
  const Palette& colors = palette();
  if (tab_ != Tab::Values)
    draw::fill(ctx, {0, kTabs, static_cast<double>(width()), kChoices}, colors.panel);
  for (const std::string& choice : choices()) {
    const ScreenRect rect = choice_rect(choice);
    for (const std::string way : {" previous", " next"})
      draw::text(ctx, *own_part(choice + way), way == " next" ? "›" : "‹", colors.accent, 20,
                 draw::Align::Center, true);
    draw::text(ctx, {rect.left + kArrow, rect.top, rect.width - 2 * kArrow, rect.height},
               name_of_choice(choice), colors.text, draw::kTextSize, draw::Align::Center);
  }
  if (const auto compute = compute_rect()) {
    draw::fill(ctx, *compute, colors.selected, 4);
    draw::text(ctx, inner(*compute), "compute " + std::to_string(missing()) + " missing",
               colors.text, draw::kSmallTextSize, draw::Align::Center);
  }
}

bool DescriptorPanel::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down,
                                       int modifiers) {
  if (down && !focused()) requestFocus();
  if (button == GLFW_MOUSE_BUTTON_LEFT && down && press(p.x() - mPos.x(), p.y() - mPos.y()))
    return true;
  Element* element = shown();
  const nanogui::Vector2i inside = p - mPos;
  if (element->contains(inside)) element->mouseButtonEvent(inside, button, down, modifiers);
  return true;
}

bool DescriptorPanel::press(double x, double y) {
  const auto hit = [&](const std::string& part) {
    const auto rect = own_part(part);
    return rect && rect->contains(x, y);
  };
  for (const Tab tab : kAllTabs)
    if (hit(part_of(tab))) return set_tab(tab), true;
  for (const std::string& choice : choices()) {
    if (hit(choice + " previous")) return step(choice, -1), true;
    if (hit(choice + " next")) return step(choice, 1), true;
  }
  if (!hit("compute")) return false;
  if (on_describe_list) on_describe_list(shown_ids());
  return true;
}

bool DescriptorPanel::keyboardEvent(int key, int /*scancode*/, int action, int modifiers) {
  if (action == GLFW_RELEASE || (modifiers & ~GLFW_MOD_SHIFT) != 0) return false;
  return this->key(key, modifiers);
}

bool DescriptorPanel::key(int key, int modifiers) {
  const bool scatter = tab_ == Tab::Scatter;
  const int last = static_cast<int>(kAllTabs.size());
  const int by = (modifiers & GLFW_MOD_SHIFT) != 0 ? last - 1 : 1;
  switch (key) {
    case GLFW_KEY_TAB:
      set_tab(kAllTabs[static_cast<std::size_t>((static_cast<int>(tab_) + by) % last)]);
      return true;
    case GLFW_KEY_UP:
    case GLFW_KEY_DOWN:
      step(scatter ? "x" : "descriptor", key == GLFW_KEY_UP ? -1 : 1);
      return true;
    case GLFW_KEY_LEFT:
    case GLFW_KEY_RIGHT:
      if (scatter) step("y", key == GLFW_KEY_LEFT ? -1 : 1);
      return scatter;
    case GLFW_KEY_ENTER:
      if (compute_rect() && on_describe_list) on_describe_list(shown_ids());
      return true;
    default:
      return false;
  }
}

}  // namespace slalom
