#pragma once

#include <slalom/gui/element.h>
#include <slalom/gui/studio_script.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// What a script needs of a window beside its elements.
struct ScriptHost {
  nanogui::Screen* screen = nullptr;
  std::function<bool()> is_idle;                            ///< no work is under way
  std::function<void(const std::string& id)> run_action;    ///< throws Error when it cannot
  std::function<void(const std::string& path)> screenshot;  ///< throws Error (Job)
  std::function<void(const std::string& text)> print;       ///< a line for whoever runs it
};

/// The element (or other widget) with this id that is shown; null when there is none. Of several
/// the one drawn last.
nanogui::Widget* find_shown(nanogui::Widget& root, const std::string& id);

/// What a widget and all inside it show, as lines.
std::string shown_text(const nanogui::Widget& widget);

/// Plays a script on a window as if a user sat before it: the same events reach the same elements.
/// One command a frame, so that everything is drawn in between.
class ScriptPlayer {
 public:
  ScriptPlayer(std::vector<ScriptCommand> script, std::string name, ScriptHost host);

  /// To be called once a frame. Throws Error (Job) naming the script's line when an element is
  /// missing, an expectation does not hold or work does not end in time.
  void step();
  bool ended() const { return next_ == script_.size() && moves_.empty(); }

 private:
  void play(const ScriptCommand& command);
  void resize(const ScriptCommand& command);
  void click(const ScriptCommand& command);
  void drag(const ScriptCommand& command);
  void begin_frames(const ScriptCommand& command);
  void count_frame();
  void type(const std::string& text);
  void press(const KeyStroke& stroke);
  bool still_waits(const ScriptCommand& command);
  void expect(const ScriptCommand& command);
  nanogui::Widget& element(const ScriptPlace& place) const;
  nanogui::Vector2f at(const ScriptPlace& place) const;  ///< pixels on the screen
  void move_to(const nanogui::Vector2f& point);
  void button(bool right, bool down, int modifiers);
  [[noreturn]] void fail(const std::string& what, const std::string& expected = "") const;

  std::vector<ScriptCommand> script_;
  std::string name_;
  ScriptHost host_;
  std::size_t next_ = 0;
  double waiting_since_ = -1;                 ///< s
  std::vector<std::function<void()>> moves_;  ///< of a drag under way, one a frame, last first
  int frames_ = 0, frames_left_ = 0;
  double frames_since_ = 0;
};

}  // namespace slalom
