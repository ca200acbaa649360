// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/gui/panel_window.h>
#include <slalom/studio/actions.h>
#include <slalom/studio/settings.h>

#include <string>
#include <vector>

namespace slalom {

class ActionFinder;
class Element;
class MenuBar;
class ScenarioView;

/// The window of Slalom Studio: lists at the left, descriptors of the current scenario below them,
/// the scenario at the right, and results below it if a result file is open.
class StudioWindow : public PanelWindow {
 public:
  /// Throws std::runtime_error without a display or OpenGL 3.3.
  StudioWindow(SceneSettings scene, const StudioSettings& settings, StudioServices services);
  StudioSettings settings() const;  ///< the current layout

  // Functions of nanogui:
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;
  bool keyboardCharacterEvent(unsigned int letter) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool dropEvent(const std::vector<std::string>& files) override;

 private:
  void make_elements();
  void add_actions();
  void add_view_actions();
  void show_layers(const std::string& names);
  void show_theme(Theme theme);
  /// Shows the error of the action, if any.
  void run_action(const std::string& id) override;
  void next_panel();  ///< moves the focus to the next panel
  void arrange() override;
  void resize_panel(int StudioSettings::*size, int by);
  bool results_shown() { return studio().results().overlay().is_open(); }
  bool has_movers();  ///< whether the current scenario has
  bool timeline_shown() { return has_movers() && !results_shown(); }
  bool handle_key(int key, int scancode, int action, int modifiers);
  nanogui::Widget* focused_text_field() const;  ///< null for none
  bool dialog_open() const;
  bool is_on_rows(const nanogui::Vector2i& p) const;
  void update() override;

  Actions actions_;
  StudioSettings settings_;
  double files_checked_at_ = 0;   ///< s
  bool key_moved_focus_ = false;  ///< the one that is pressed
  // Owned by the composite of elements:
  MenuBar* menu_ = nullptr;
  ActionFinder* finder_ = nullptr;
  Element *list_ = nullptr, *descriptors_ = nullptr, *results_ = nullptr, *timeline_ = nullptr;
  ScenarioView* view_ = nullptr;
};

}  // namespace slalom
