#pragma once

#include <slalom/gui/key_stroke.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// One thing that a user can do: menus, keys, the help panel and scripts all come from here.
struct Action {
  std::string id;        ///< "edit.undo"
  std::string menu;      ///< "Edit"
  std::string title;     ///< "Undo"
  std::string shortcut;  ///< "Ctrl+Z"; empty for none
  std::string help;      ///< one sentence
  std::function<void()> run;
  /// Why it cannot be done as things are; empty (or no function) when it can.
  std::function<std::string()> obstacle = {};
  /// What it would do as things are, in place of the title ("Undo delete of 3 scenarios").
  std::function<std::string()> now = {};
  /// Of what is switched on and off: whether it is on.
  std::function<bool()> checked = {};

  std::string why_not() const { return obstacle ? obstacle() : std::string(); }
  std::string label() const { return now ? now() : title; }
};

/// All actions in the order of the menus.
class Actions {
 public:
  /// Requires an id and a key that no other action has.
  void add(Action action);
  const std::vector<Action>& all() const { return actions_; }
  std::vector<std::string> menus() const;  ///< in order, each once
  std::vector<const Action*> of_menu(const std::string& menu) const;
  /// Throws Error (Usage) naming the nearest.
  const Action& find(const std::string& id) const;
  /// Null when no action has that key.
  const Action* find(const KeyStroke& stroke) const;
  /// Does it; Error (Usage) with the reason when it cannot be done.
  void run(const std::string& id) const;

 private:
  std::vector<Action> actions_;
};

}  // namespace slalom
