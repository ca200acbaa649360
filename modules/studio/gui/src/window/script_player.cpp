// SPDX-License-Identifier: BSD-3-Clause
#include "window/script_player.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

namespace slalom {
namespace {

using Kind = ScriptCommand::Kind;
using nanogui::Vector2f;

constexpr double kMaxWait = 300;                         // s for jobs to end
constexpr double kStableTime = 0.1, kMaxResizeWait = 5;  // s
/// s between frames while a script waits: a job that ends posts an event.
constexpr double kWaitInterval = 0.1;
constexpr int kDragSteps = 6;
constexpr float kDragAmplitude = 60;  // pixels, of `fps`

void list_ids(const nanogui::Widget& widget, std::string& ids) {
  if (!widget.visible()) return;
  if (!widget.id().empty()) ids += (ids.empty() ? "" : ", ") + widget.id();
  for (const nanogui::Widget* child : widget.children()) list_ids(*child, ids);
}

std::string own_text(const nanogui::Widget& widget) {
  if (const auto* element = dynamic_cast<const Element*>(&widget)) return element->text();
  if (const auto* box = dynamic_cast<const nanogui::TextBox*>(&widget)) return box->value();
  return "";
}

/// Decodes the UTF-8 character of `text` at `i` and advances `i`.
unsigned int decode_utf8(const std::string& text, std::size_t& i) {
  const auto first = static_cast<unsigned char>(text[i++]);
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  unsigned int code_point = more == 0 ? first : first & (0x3FU >> static_cast<unsigned>(more));
  for (int k = 0; k < more && i < text.size(); ++k)
    code_point = code_point << 6U | (static_cast<unsigned char>(text[i++]) & 0x3FU);
  return code_point;
}

class ScriptPlayer {
 public:
  ScriptPlayer(std::vector<ScriptCommand> script, std::string name, ScriptHost host)
      : script_(std::move(script)), name_(std::move(name)), host_(std::move(host)) {}

  /// To be called once per frame.
  void step() {
    if (!pending_moves_.empty()) {
      pending_moves_.back()();
      pending_moves_.pop_back();
      if (pending_moves_.empty()) ++next_;
      return;
    }
    if (frames_left_ > 0) return count_frame();
    if (ended() || is_waiting(script_[next_])) return;
    try {
      play(script_[next_]);
    } catch (const Error& error) {
      const std::string where = name_ + ":";
      if (std::string(error.what()).rfind(where, 0) == 0) throw;
      fail(error.what());
    }
    if (pending_moves_.empty() && frames_left_ == 0) ++next_;
  }
  /// For jobs, or for what they show.
  bool waits() const { return wait_start_ >= 0; }
  /// Whether the next frame is to be seen: of `fps`, and ten times per second while a script waits.
  bool shows_frame() {
    if (frames_left_ > 0) return true;
    const double now = glfwGetTime();
    if (!waits() || now - std::max(wait_start_, shown_at_) < kWaitInterval) return false;
    shown_at_ = now;
    return true;
  }
  bool ended() const { return next_ == script_.size() && pending_moves_.empty(); }

 private:
  void play(const ScriptCommand& command) {
    const std::map<Kind, std::function<void()>> actions = {
        {Kind::Size, [&] { resize(command); }},
        {Kind::Do, [&] { host_.run_action(command.text); }},
        {Kind::Click, [&] { click(command); }},
        {Kind::Move, [&] { move_to(at(command.target)); }},
        {Kind::Drag, [&] { drag(command); }},
        {Kind::Wheel, [&] { turn_wheel(command); }},
        {Kind::Type, [&] { type(command.text); }},
        {Kind::Key, [&] { strike(command.key, letter_typed_by(command.key)); }},
        {Kind::Drop, [&] { drop(command.files); }},
        {Kind::Wait, [] {}},
        {Kind::Screenshot, [&] { host_.screenshot(command.text); }},
        {Kind::Expect, [&] { expect(command); }},
        {Kind::Print, [&] { std::cout << shown_text(element(command.target)) << "\n"; }},
        {Kind::Fps, [&] { begin_frames(command); }}};
    actions.at(command.kind)();
  }
  /// The display reports the new size with a delay, and may report older sizes before: waits until
  /// no other size was reported for kStableTime.
  void resize(const ScriptCommand& command) {
    GLFWwindow* window = host_.screen->glfwWindow();
    host_.screen->setSize({command.width, command.height});
    const auto scaled = [this](int size) {
      return static_cast<int>(static_cast<float>(size) * host_.screen->pixelRatio());
    };
    const double begin = glfwGetTime();
    double stable_since = begin;
    while (glfwGetTime() - stable_since < kStableTime && glfwGetTime() - begin < kMaxResizeWait) {
      glfwWaitEventsTimeout(0.02);
      int width = 0, height = 0;
      glfwGetWindowSize(window, &width, &height);
      if (width != scaled(command.width) || height != scaled(command.height))
        stable_since = glfwGetTime();
    }
    host_.screen->resizeCallbackEvent(scaled(command.width), scaled(command.height));
  }
  void click(const ScriptCommand& command) {
    move_to(at(command.target));
    for (int i = 0; i < (command.double_click ? 2 : 1); ++i) {
      button(command.right, true, command.modifiers);
      button(command.right, false, command.modifiers);
    }
  }
  void drag(const ScriptCommand& command) {
    const Vector2f from = at(command.target), to = at(command.drag_target);
    pending_moves_.push_back([=] { button(command.right, false, command.modifiers); });
    for (int i = kDragSteps; i > 0; --i)
      pending_moves_.push_back(
          [=] { move_to(from + (to - from) * (static_cast<float>(i) / kDragSteps)); });
    pending_moves_.push_back([=] { button(command.right, true, command.modifiers); });
    move_to(from);
  }
  void begin_frames(const ScriptCommand& command) {
    move_to(at(command.target));
    button(false, true, 0);
    frames_ = frames_left_ = static_cast<int>(command.number);
    frames_start_ = glfwGetTime();
  }
  void count_frame() {
    const float amplitude = (frames_left_ / 20) % 2 == 0 ? kDragAmplitude : -kDragAmplitude;
    move_to(at(script_[next_].target) +
            Vector2f(amplitude * static_cast<float>(frames_left_ % 20) / 20.0F, 0));
    if (--frames_left_ > 0) return;
    button(false, false, 0);
    const double elapsed = glfwGetTime() - frames_start_;
    std::cout << "frames per second: " << format_fixed(frames_ / elapsed, 1) << "\n";
    ++next_;
  }
  void type(const std::string& text) {
    for (std::size_t i = 0; i < text.size();) {
      const unsigned int letter = decode_utf8(text, i);
      strike(key_stroke_typing(letter), letter);
    }
  }
  void turn_wheel(const ScriptCommand& command) {
    move_to(at(command.target));
    host_.screen->scrollCallbackEvent(0, command.number);
  }
  void drop(const std::vector<std::string>& files) {
    std::vector<const char*> names;
    for (const std::string& file : files) names.push_back(file.c_str());
    host_.screen->dropCallbackEvent(static_cast<int>(names.size()), names.data());
  }
  /// The events in the order of GLFW: key down, character, key up.
  void strike(const KeyStroke& stroke, unsigned int letter) {
    host_.screen->keyCallbackEvent(stroke.key, 0, GLFW_PRESS, stroke.modifiers);
    if (letter != 0) host_.screen->charCallbackEvent(letter);
    host_.screen->keyCallbackEvent(stroke.key, 0, GLFW_RELEASE, stroke.modifiers);
  }
  bool is_waiting(const ScriptCommand& command) {
    if (command.kind != Kind::Wait) return false;
    const double now = glfwGetTime();
    if (wait_start_ < 0) {
      wait_start_ = now;
      return true;  // at least one frame, which shows the effect of the previous command
    }
    const double waited = now - wait_start_;
    const bool expects = !command.target.element.empty();
    const bool over = command.number > 0 ? waited >= command.number
                      : expects          ? holds(command)
                                         : host_.jobs->idle();
    if (!over && waited > kMaxWait)
      expects ? expect(command) : fail("jobs did not end within 300 s");
    if (over) wait_start_ = -1;
    return !over;
  }
  bool holds(const ScriptCommand& command) const {
    const std::string text = shown_text(element(command.target));
    const bool contains = text.find(command.text) != std::string::npos;
    return command.relation == "is" ? text == command.text
                                    : contains == (command.relation == "contains");
  }
  void expect(const ScriptCommand& command) const {
    if (!holds(command))
      fail("'" + command.target.element + "' shows '" + shown_text(element(command.target)) + "'",
           "a text that " + command.relation + " '" + command.text + "'");
  }
  nanogui::Widget& element(const ScriptTarget& target) const {
    if (nanogui::Widget* found = find_visible_widget(*host_.screen, target.element)) return *found;
    std::string ids;
    list_ids(*host_.screen, ids);
    fail("unknown element '" + target.element + "'", "one of " + ids);
  }
  /// In screen coordinates (pixels).
  nanogui::Vector2f at(const ScriptTarget& target) const {
    const nanogui::Widget& widget = element(target);
    ScreenRect rect{0, 0, static_cast<double>(widget.width()),
                    static_cast<double>(widget.height())};
    if (!target.part.empty()) {
      const auto* named = dynamic_cast<const Element*>(&widget);
      const auto found = named ? named->rect_of(target.part) : std::nullopt;
      if (!found) fail("'" + target.element + "' has no visible part '" + target.part + "'");
      rect = *found;
    }
    const nanogui::Vector2i origin = widget.absolutePosition();
    return {static_cast<float>(origin.x() + rect.left + target.x * rect.width),
            static_cast<float>(origin.y() + rect.top + target.y * rect.height)};
  }
  void move_to(const Vector2f& point) {
    // nanogui subtracts (1, 2) pixels for the shape of the cursor
    const auto scale = static_cast<double>(host_.screen->pixelRatio());
    host_.screen->cursorPosCallbackEvent(std::ceil(scale * (std::floor(point.x()) + 1)),
                                         std::ceil(scale * (std::floor(point.y()) + 2)));
  }
  void button(bool right, bool down, int modifiers) {
    host_.screen->mouseButtonCallbackEvent(right ? GLFW_MOUSE_BUTTON_RIGHT : GLFW_MOUSE_BUTTON_LEFT,
                                           down ? GLFW_PRESS : GLFW_RELEASE, modifiers);
  }
  [[noreturn]] void fail(const std::string& what, const std::string& expected = "") const {
    throw job_error(name_ + ":" + std::to_string(script_[next_].line), what, expected);
  }

  std::vector<ScriptCommand> script_;
  std::string name_;
  ScriptHost host_;
  std::size_t next_ = 0;
  double wait_start_ = -1, frames_start_ = 0, shown_at_ = 0;  ///< s
  std::vector<std::function<void()>> pending_moves_;  ///< of a drag, one per frame, last first
  int frames_ = 0, frames_left_ = 0;
};

}  // namespace

nanogui::Widget* find_visible_widget(nanogui::Widget& root, const std::string& id) {
  const auto& children = root.children();
  for (auto child = children.rbegin(); child != children.rend(); ++child)
    if ((*child)->visible())
      if (nanogui::Widget* found = find_visible_widget(**child, id)) return found;
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

void play_script(const std::vector<ScriptCommand>& script, const std::string& name,
                 const ScriptHost& host) {
  ScriptPlayer player(script, name, host);
  while (!player.ended() && host.draw_frame(player.shows_frame())) {
    player.step();
    if (player.waits())
      glfwWaitEventsTimeout(kWaitInterval);
    else
      glfwPollEvents();
  }
}

}  // namespace slalom
