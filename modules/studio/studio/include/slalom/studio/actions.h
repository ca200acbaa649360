// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

class Studio;

/// A key with modifiers, as GLFW codes.
struct KeyStroke {
  int key = 0;
  int modifiers = 0;
  bool operator==(const KeyStroke& o) const { return key == o.key && modifiers == o.modifiers; }
};

/// Parses "Ctrl+Shift+Z", "Delete", "F5", "Left"; case-insensitive. Throws Error (Usage) with the
/// known names.
KeyStroke key_stroke_of(const std::string& name);

// The letters of an American keyboard, which GLFW's numbers of keys speak of.
/// Keys to press for a letter (Unicode); GLFW_KEY_UNKNOWN if there are none.
KeyStroke key_stroke_typing(unsigned int letter);
/// Whether a text field takes the stroke: it types a letter, or moves and edits in a text.
bool is_key_of_text(const KeyStroke& stroke);
/// Letter that a key types; 0 for nothing, as with Ctrl or Alt.
unsigned int letter_typed_by(const KeyStroke& stroke);

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
  /// Whether menus leave the action out now.
  std::function<bool()> hidden = {};

  std::string disabled_reason() const { return disabled_check ? disabled_check() : std::string(); }
  bool is_hidden() const { return hidden && hidden(); }
  std::string label() const { return current_label ? current_label() : title; }
};

/// Keys of a panel of the window, for the help; they act while it has the focus.
struct PanelKey {
  std::string panel;              ///< the id of its element
  std::vector<std::string> keys;  ///< for key_stroke_of()
  std::string help;
};
const std::vector<PanelKey>& panel_keys();

/// The actions on the scenarios of a list, by id, for its context menu.
const std::vector<std::string>& scenario_actions();

/// All actions, in menu order.
class Actions {
 public:
  /// Requires a unique id and a unique shortcut. Throws std::logic_error otherwise.
  void add(Action action);
  const std::vector<Action>& all() const { return actions_; }
  std::vector<std::string> menus() const;  ///< in order, without duplicates
  /// Leaves out hidden ones.
  std::vector<const Action*> of_menu(const std::string& menu) const;
  /// Actions whose menu and label contain each of the words, in any order and case. Leaves out
  /// hidden ones.
  std::vector<const Action*> matching(const std::string& words) const;
  /// Throws Error (Usage) naming the nearest id.
  const Action& find(const std::string& id) const;
  /// Null when no action has this shortcut.
  const Action* find(const KeyStroke& stroke) const;
  /// Runs the action. Throws Error (Usage) with the reason when it is disabled.
  void run(const std::string& id) const;

 private:
  std::vector<Action> actions_;
};

// The actions of the studio, menu by menu in order, for menus, keyboard shortcuts, the help and
// scripts. The window adds those that concern only itself.

void add_file_actions(Actions& actions, Studio& studio);
void add_edit_actions(Actions& actions, Studio& studio);
void add_list_actions(Actions& actions, Studio& studio);
void add_generate_actions(Actions& actions, Studio& studio);
/// `actions` must outlive the studio's events.
void add_help_actions(Actions& actions, Studio& studio);

/// The recent files, of the menu File.
void add_recent_actions(Actions& actions, Studio& studio);
/// Import and export, of the menu File.
void add_import_export_actions(Actions& actions, Studio& studio);
/// Running the methods of a campaign on the current scenario, of the menu Generate.
void add_run_actions(Actions& actions, Studio& studio);
/// Shrinking the selected run, of the menu Generate: why it is not possible (empty if it is), and
/// its form.
std::string shrink_disabled_reason(Studio& studio);
void open_shrink_form(Studio& studio);
/// Opens lists and results, and the import form for other files.
void open_files(Studio& studio, std::vector<std::string> files);

}  // namespace slalom
