#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/gui/script_player.h>

#include <GLFW/glfw3.h>
#include <cmath>

namespace slalom {
namespace {

using Kind = ScriptCommand::Kind;
using nanogui::Vector2f;

constexpr double kLongestWait = 300;                    // s until work has to end
constexpr double kQuietTime = 0.1, kLongestResize = 5;  // s
constexpr int kMovesOfDrag = 6;
constexpr float kFrameReach = 60;  // pixels by which `fps` drags to and fro

void list_ids(const nanogui::Widget& widget, std::string& ids) {
  if (!widget.visible()) return;
  if (!widget.id().empty()) ids += (ids.empty() ? "" : ", ") + widget.id();
  for (const nanogui::Widget* child : widget.children()) list_ids(*child, ids);
}

std::string own_text(const nanogui::Widget& widget) {
  if (const auto* element = dynamic_cast<const Element*>(&widget)) return element->text();
  if (const auto* label = dynamic_cast<const nanogui::Label*>(&widget)) return label->caption();
  if (const auto* box = dynamic_cast<const nanogui::TextBox*>(&widget)) return box->value();
  if (const auto* box = dynamic_cast<const nanogui::CheckBox*>(&widget))
    return (box->checked() ? "[x] " : "[ ] ") + box->caption();
  if (const auto* button = dynamic_cast<const nanogui::Button*>(&widget)) return button->caption();
  if (const auto* window = dynamic_cast<const nanogui::Window*>(&widget)) return window->title();
  return "";
}

/// One letter of UTF-8 from `text` at `i`, which moves behind it.
unsigned int take_letter(const std::string& text, std::size_t& i) {
  const auto first = static_cast<unsigned char>(text[i++]);
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  unsigned int letter = more == 0 ? first : first & (0x3FU >> static_cast<unsigned>(more));
  for (int k = 0; k < more && i < text.size(); ++k)
    letter = letter << 6U | (static_cast<unsigned char>(text[i++]) & 0x3FU);
  return letter;
}

}  // namespace

nanogui::Widget* find_shown(nanogui::Widget& root, const std::string& id) {
  const auto& children = root.children();
  for (auto child = children.rbegin(); child != children.rend(); ++child)
    if ((*child)->visible())
      if (nanogui::Widget* found = find_shown(**child, id)) return found;
  return root.id() == id ? &root : nullptr;
}

std::string shown_text(const nanogui::Widget& widget) {
  std::string text = own_text(widget);
  for (const nanogui::Widget* child : widget.children())
    if (child->visible()) {
      const std::string more = shown_text(*child);
      if (!more.empty()) text += (text.empty() ? "" : "\n") + more;
    }
  return text;
}

ScriptPlayer::ScriptPlayer(std::vector<ScriptCommand> script, std::string name, ScriptHost host)
    : script_(std::move(script)), name_(std::move(name)), host_(std::move(host)) {}

void ScriptPlayer::fail(const std::string& what, const std::string& expected) const {
  throw job_error(name_ + ":" + std::to_string(script_[next_].line), what, expected);
}

void ScriptPlayer::step() {
  if (!moves_.empty()) {
    moves_.back()();
    moves_.pop_back();
    if (moves_.empty()) ++next_;
    return;
  }
  if (frames_left_ > 0) return count_frame();
  if (ended() || still_waits(script_[next_])) return;
  try {
    play(script_[next_]);
  } catch (const Error& error) {
    const std::string where = name_ + ":";
    if (std::string(error.what()).rfind(where, 0) == 0) throw;
    fail(error.what());
  }
  if (moves_.empty() && frames_left_ == 0) ++next_;
}

/// The display takes its time to tell that the window has another size, and may tell of an older
/// one before: the size counts when nothing else was told for a while.
void ScriptPlayer::resize(const ScriptCommand& command) {
  GLFWwindow* window = host_.screen->glfwWindow();
  host_.screen->setSize({command.width, command.height});
  const double begin = glfwGetTime();
  double since = begin;
  while (glfwGetTime() - since < kQuietTime && glfwGetTime() - begin < kLongestResize) {
    glfwWaitEventsTimeout(0.02);
    int width = 0, height = 0;
    glfwGetWindowSize(window, &width, &height);
    if (width != command.width || height != command.height) since = glfwGetTime();
  }
  host_.screen->resizeCallbackEvent(command.width, command.height);
}

bool ScriptPlayer::still_waits(const ScriptCommand& command) {
  if (command.kind != Kind::Wait) return false;
  const double now = glfwGetTime();
  if (waiting_since_ < 0) {
    waiting_since_ = now;
    return true;  // one frame at least: what the last command began shows in it
  }
  const double waited = now - waiting_since_;
  const bool over = command.number > 0 ? waited >= command.number : host_.is_idle();
  if (!over && waited > kLongestWait) fail("work did not end within 300 s");
  if (over) waiting_since_ = -1;
  return !over;
}

void ScriptPlayer::play(const ScriptCommand& command) {
  switch (command.kind) {
    case Kind::Size:
      resize(command);
      break;
    case Kind::Do:
      host_.run_action(command.text);
      break;
    case Kind::Click:
      click(command);
      break;
    case Kind::Move:
      move_to(at(command.place));
      break;
    case Kind::Drag:
      drag(command);
      break;
    case Kind::Wheel:
      move_to(at(command.place));
      host_.screen->scrollCallbackEvent(0, command.number);
      break;
    case Kind::Type:
      type(command.text);
      break;
    case Kind::Key:
      press(command.key);
      break;
    case Kind::Drop: {
      std::vector<const char*> names;
      for (const std::string& file : command.files) names.push_back(file.c_str());
      host_.screen->dropCallbackEvent(static_cast<int>(names.size()), names.data());
      break;
    }
    case Kind::Wait:
      break;
    case Kind::Screenshot:
      host_.screenshot(command.text);
      break;
    case Kind::Expect:
      expect(command);
      break;
    case Kind::Print:
      host_.print(shown_text(element(command.place)));
      break;
    case Kind::Fps:
      begin_frames(command);
      break;
  }
}

nanogui::Widget& ScriptPlayer::element(const ScriptPlace& place) const {
  if (nanogui::Widget* found = find_shown(*host_.screen, place.element)) return *found;
  std::string ids;
  list_ids(*host_.screen, ids);
  fail("no element '" + place.element + "' is shown", "one of " + ids);
}

Vector2f ScriptPlayer::at(const ScriptPlace& place) const {
  const nanogui::Widget& widget = element(place);
  ScreenRect rect{0, 0, static_cast<double>(widget.width()), static_cast<double>(widget.height())};
  if (!place.part.empty()) {
    const auto* named = dynamic_cast<const Element*>(&widget);
    const auto found = named ? named->rect_of(place.part) : std::nullopt;
    if (!found) fail("'" + place.element + "' shows no part '" + place.part + "'");
    rect = *found;
  }
  const nanogui::Vector2i origin = widget.absolutePosition();
  return {static_cast<float>(origin.x() + rect.left + place.x * rect.width),
          static_cast<float>(origin.y() + rect.top + place.y * rect.height)};
}

void ScriptPlayer::move_to(const Vector2f& point) {
  // nanogui takes a pixel and two off, for the shape of the arrow
  host_.screen->cursorPosCallbackEvent(std::floor(point.x()) + 1, std::floor(point.y()) + 2);
}

void ScriptPlayer::button(bool right, bool down, int modifiers) {
  host_.screen->mouseButtonCallbackEvent(right ? GLFW_MOUSE_BUTTON_RIGHT : GLFW_MOUSE_BUTTON_LEFT,
                                         down ? GLFW_PRESS : GLFW_RELEASE, modifiers);
}

void ScriptPlayer::click(const ScriptCommand& command) {
  move_to(at(command.place));
  for (int i = 0; i < (command.twice ? 2 : 1); ++i) {
    button(command.right, true, command.modifiers);
    button(command.right, false, command.modifiers);
  }
}

void ScriptPlayer::drag(const ScriptCommand& command) {
  const Vector2f from = at(command.place), to = at(command.target);
  moves_.push_back([=] { button(command.right, false, command.modifiers); });
  for (int i = kMovesOfDrag; i > 0; --i)
    moves_.push_back([=] { move_to(from + (to - from) * (static_cast<float>(i) / kMovesOfDrag)); });
  moves_.push_back([=] { button(command.right, true, command.modifiers); });
  move_to(from);
}

void ScriptPlayer::begin_frames(const ScriptCommand& command) {
  move_to(at(command.place));
  button(false, true, 0);
  frames_ = frames_left_ = static_cast<int>(command.number);
  frames_since_ = glfwGetTime();
}

void ScriptPlayer::count_frame() {
  const float reach = (frames_left_ / 20) % 2 == 0 ? kFrameReach : -kFrameReach;
  move_to(at(script_[next_].place) + Vector2f(reach * (frames_left_ % 20) / 20.0F, 0));
  if (--frames_left_ > 0) return;
  button(false, false, 0);
  const double taken = glfwGetTime() - frames_since_;
  host_.print("frames per second: " + format_fixed(frames_ / taken, 1));
  ++next_;
}

void ScriptPlayer::type(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) host_.screen->charCallbackEvent(take_letter(text, i));
}

void ScriptPlayer::press(const KeyStroke& stroke) {
  host_.screen->keyCallbackEvent(stroke.key, 0, GLFW_PRESS, stroke.modifiers);
  host_.screen->keyCallbackEvent(stroke.key, 0, GLFW_RELEASE, stroke.modifiers);
}

void ScriptPlayer::expect(const ScriptCommand& command) {
  const std::string text = shown_text(element(command.place));
  const bool contains = text.find(command.text) != std::string::npos;
  const bool holds = command.relation == "is"         ? text == command.text
                     : command.relation == "contains" ? contains
                                                      : !contains;
  if (!holds)
    fail("'" + command.place.element + "' shows '" + text + "'",
         "that it " + command.relation + " '" + command.text + "'");
}

}  // namespace slalom
