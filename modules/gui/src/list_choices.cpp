#include <slalom/gui/drawing.h>
#include <slalom/gui/list_choices.h>
#include <slalom/gui/palette.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kChoiceHeight = 24, kBorder = 2;

}  // namespace

ListChoices::ListChoices(nanogui::Widget* parent) : Element(parent, "choices") {
  setVisible(false);
}

void ListChoices::open(const ScreenRect& anchor, double bottom, std::vector<std::string> choices,
                       std::size_t current, Chosen on_chosen) {
  choices_ = std::move(choices);
  marked_ = std::min(current, choices_.empty() ? 0 : choices_.size() - 1);
  on_chosen_ = std::move(on_chosen);
  const double top = anchor.top + anchor.height;
  const double wanted = static_cast<double>(choices_.size()) * kChoiceHeight + 2 * kBorder;
  setPosition({static_cast<int>(anchor.left), static_cast<int>(top)});
  setSize({static_cast<int>(anchor.width),
           static_cast<int>(std::clamp(bottom - top, kChoiceHeight + 2 * kBorder, wanted))});
  first_ = 0;
  keep_in_view(marked_);
  setVisible(true);
  requestFocus();
}

void ListChoices::close() {
  setVisible(false);
}

std::size_t ListChoices::seen() const {
  return static_cast<std::size_t>(std::max((height() - 2 * kBorder) / kChoiceHeight, 1.0));
}

void ListChoices::keep_in_view(std::size_t choice) const {
  if (choice < first_) first_ = choice;
  if (choice >= first_ + seen()) first_ = choice + 1 - seen();
}

std::string ListChoices::text() const {
  std::string text;
  for (std::size_t i = 0; i < choices_.size(); ++i)
    text += (i > 0 ? "\n" : "") + std::string(i == marked_ ? "> " : "") + choices_[i];
  return text;
}

std::optional<ScreenRect> ListChoices::rect_of(const std::string& part) const {
  const std::string word = "choice ";
  if (part.rfind(word, 0) != 0) return Element::rect_of(part);
  const auto at = std::find(choices_.begin(), choices_.end(), part.substr(word.size()));
  if (at == choices_.end() || !visible()) return std::nullopt;
  const auto choice = static_cast<std::size_t>(at - choices_.begin());
  keep_in_view(choice);
  return ScreenRect{kBorder, kBorder + static_cast<double>(choice - first_) * kChoiceHeight,
                    width() - 2 * kBorder, kChoiceHeight};
}

void ListChoices::draw(NVGcontext* ctx) {
  const Palette& colors = palette();
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  const ScreenRect whole = *Element::rect_of("");
  draw::fill(ctx, whole, colors.window);
  for (std::size_t i = first_; i < std::min(choices_.size(), first_ + seen()); ++i) {
    const ScreenRect rect = *rect_of("choice " + choices_[i]);
    if (i == marked_) draw::fill(ctx, rect, colors.selected);
    draw::text(ctx, {rect.left + 8, rect.top, rect.width - 20, rect.height}, choices_[i],
               colors.text);
  }
  if (seen() < choices_.size()) {
    const double part = (height() - 2 * kBorder) / static_cast<double>(choices_.size());
    draw::fill(ctx,
               {width() - 8.0, kBorder + part * static_cast<double>(first_), 5,
                part * static_cast<double>(seen())},
               colors.faint_text, 2);
  }
  draw::frame(ctx, whole, colors.accent);
  nvgRestore(ctx);
}

std::optional<std::size_t> ListChoices::choice_at(const nanogui::Vector2i& p) const {
  const double y = p.y() - mPos.y() - kBorder;
  const auto line = static_cast<std::ptrdiff_t>(std::floor(y / kChoiceHeight));
  if (line < 0 || static_cast<std::size_t>(line) >= seen()) return std::nullopt;
  const std::size_t choice = first_ + static_cast<std::size_t>(line);
  return choice < choices_.size() ? std::make_optional(choice) : std::nullopt;
}

void ListChoices::choose(std::size_t choice) {
  const Chosen chosen = on_chosen_;
  close();
  if (on_closed) on_closed();
  if (chosen) chosen(choice);
}

bool ListChoices::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int) {
  const auto choice = choice_at(p);
  if (button == GLFW_MOUSE_BUTTON_LEFT && down && choice) choose(*choice);
  return true;
}

bool ListChoices::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i&, int, int) {
  if (const auto choice = choice_at(p)) marked_ = *choice;
  return true;
}

bool ListChoices::scrollEvent(const nanogui::Vector2i&, const nanogui::Vector2f& rel) {
  const std::size_t most = choices_.size() - std::min(seen(), choices_.size());
  first_ = rel.y() > 0 ? first_ - std::min<std::size_t>(first_, 3) : std::min(first_ + 3, most);
  return true;
}

bool ListChoices::keyboardEvent(int key, int, int action, int) {
  if (action == GLFW_RELEASE || choices_.empty()) return true;
  switch (key) {
    case GLFW_KEY_UP:
      marked_ -= std::min<std::size_t>(marked_, 1);
      break;
    case GLFW_KEY_DOWN:
      marked_ = std::min(marked_ + 1, choices_.size() - 1);
      break;
    case GLFW_KEY_HOME:
      marked_ = 0;
      break;
    case GLFW_KEY_END:
      marked_ = choices_.size() - 1;
      break;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      choose(marked_);
      return true;
    default:
      if (key != GLFW_KEY_ESCAPE) return false;
      close();
      if (on_closed) on_closed();
      return true;
  }
  keep_in_view(marked_);
  return true;
}

bool ListChoices::focusEvent(bool focused) {
  if (!focused) close();
  return Element::focusEvent(focused);
}

}  // namespace slalom
