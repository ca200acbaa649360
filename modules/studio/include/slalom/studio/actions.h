#pragma once

#include <slalom/studio/key_stroke.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// An action of the user. Menus, keyboard shortcuts, the help and scripts are made from these.
struct Action {
  std::string id;        ///< "edit.undo"
  std::string menu;      ///< "Edit"
  std::string title;     ///< "Undo"
  std::string shortcut;  ///< "Ctrl+Z"; empty for none
  std::string help;      ///< one sentence
  std::function<void()> run;
  /// Returns why the action is disabled; an empty text (or no function) means enabled.
  std::function<std::string()> disabled_check = {};
  /// Returns the current label, in place of the title ("Undo: delete 3 scenarios").
  std::function<std::string()> current_label = {};
  /// Whether a toggle action is on.
  std::function<bool()> checked = {};

  std::string disabled_reason() const { return disabled_check ? disabled_check() : std::string(); }
  std::string label() const { return current_label ? current_label() : title; }
};

/// All actions, in menu order.
class Actions {
 public:
  /// Requires a unique id and a unique shortcut. Throws std::logic_error otherwise.
  void add(Action action);
  const std::vector<Action>& all() const { return actions_; }
  std::vector<std::string> menus() const;  ///< in order, without duplicates
  std::vector<const Action*> of_menu(const std::string& menu) const;
  /// Throws Error (Usage) naming the nearest id.
  const Action& find(const std::string& id) const;
  /// Null when no action has this shortcut.
  const Action* find(const KeyStroke& stroke) const;
  /// Runs the action. Throws Error (Usage) with the reason when it is disabled.
  void run(const std::string& id) const;

 private:
  std::vector<Action> actions_;
};

}  // namespace slalom
