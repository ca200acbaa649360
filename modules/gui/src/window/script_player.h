#pragma once

#include "widgets/element.h"

#include <slalom/studio/script.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Services of the window that a script uses.
struct ScriptHost {
  nanogui::Screen* screen = nullptr;
  std::function<bool()> is_idle;                            ///< no job is running
  std::function<void(const std::string& id)> run_action;    ///< throws Error if disabled or unknown
  std::function<void(const std::string& path)> screenshot;  ///< throws Error (Job)
  std::function<void(const std::string& text)> print;       ///< to standard output
};

/// The visible element (or other widget) with this id; null if there is none. If there are several,
/// the one drawn last.
nanogui::Widget* find_visible_widget(nanogui::Widget& root, const std::string& id);

/// The text of a widget and its children, as lines.
std::string shown_text(const nanogui::Widget& widget);

/// Plays a script by sending mouse and keyboard events to the window. Executes one command per
/// frame, so that the window is drawn in between.
class ScriptPlayer {
 public:
  ScriptPlayer(std::vector<ScriptCommand> script, std::string name, ScriptHost host);

  /// To be called once per frame. Throws Error (Job) with the line of the script when an element is
  /// missing, an expectation fails or a job does not end in time.
  void step();
  bool ended() const { return next_ == script_.size() && pending_moves_.empty(); }

 private:
  void play(const ScriptCommand& command);
  void resize(const ScriptCommand& command);
  void click(const ScriptCommand& command);
  void drag(const ScriptCommand& command);
  void begin_frames(const ScriptCommand& command);
  void count_frame();
  void type(const std::string& text);
  void turn_wheel(const ScriptCommand& command);
  void drop(const std::vector<std::string>& files);
  void strike(const KeyStroke& stroke, unsigned int letter);
  bool is_waiting(const ScriptCommand& command);
  void expect(const ScriptCommand& command);
  nanogui::Widget& element(const ScriptTarget& target) const;
  nanogui::Vector2f at(const ScriptTarget& target) const;  ///< in screen coordinates (pixels)
  void move_to(const nanogui::Vector2f& point);
  void button(bool right, bool down, int modifiers);
  [[noreturn]] void fail(const std::string& what, const std::string& expected = "") const;

  std::vector<ScriptCommand> script_;
  std::string name_;
  ScriptHost host_;
  std::size_t next_ = 0;
  double wait_start_ = -1;                            ///< s
  std::vector<std::function<void()>> pending_moves_;  ///< of a drag, one per frame, last first
  int frames_ = 0, frames_left_ = 0;
  double frames_start_ = 0;
};

}  // namespace slalom
