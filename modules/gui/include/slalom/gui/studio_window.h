#pragma once

#include <slalom/gui/actions.h>
#include <slalom/gui/script_player.h>
#include <slalom/gui/studio.h>
#include <slalom/gui/studio_settings.h>

#include <mrpt/gui/CDisplayWindowGUI.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

class DescriptorPanel;
class ListPanel;
class MenuBar;
class MenuPopup;
class ResultsPanel;
class ScenarioView;
class Splitter;
class StatusBar;

/// The window of Slalom Studio: lists at the left, descriptors of the current scenario at the upper
/// right, the scenario below them, results under it where a result file is open. It arranges the
/// elements and passes on between them; what the user does goes to a Studio.
class StudioWindow : public mrpt::gui::CDisplayWindowGUI {
 public:
  /// Throws std::runtime_error where there is no display or no OpenGL 3.3.
  StudioWindow(SceneSettings scene, const StudioSettings& settings);
  ~StudioWindow() override;

  Studio& studio() { return *studio_; }
  Actions& actions() { return actions_; }
  ScenarioView& view() { return *view_; }
  ListPanel& list() { return *list_; }
  /// To be called once all actions are there.
  void finish();

  void say(const std::string& message, bool is_error = false);
  /// In a window of its own, until the user has read it.
  void show_message(const std::string& title, const std::string& text);
  /// Does it; what is in the way is said instead.
  void run_action(const std::string& id);
  void show_results(bool shown);
  bool results_shown() const { return results_shown_; }
  void next_panel();  ///< gives it the keyboard

  /// Draws, works and listens until the window is closed. With a script until that ends; throws
  /// what the script does.
  void run(ScriptPlayer* script);
  void save_picture(const std::string& path);  ///< throws Error (Job)
  StudioSettings settings() const;             ///< as the window is now

  // Of nanogui:
  void performLayout(NVGcontext* ctx) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool resizeEvent(const nanogui::Vector2i& size) override;
  bool dropEvent(const std::vector<std::string>& files) override;

  std::function<void(const std::vector<std::string>& files)> on_drop;

 private:
  void make_elements();
  void connect();
  void show_layers(const std::string& names);
  void show_documents();
  void show_current();
  void connect_descriptors();
  void show_list_values();
  void show_progress();
  void arrange();
  void place(nanogui::Widget& widget, int left, int top, int width, int height) const;
  bool menu_key(int key);
  bool typing() const;  ///< the keyboard belongs to a text
  bool dialog_open() const;
  void frame();

  std::unique_ptr<Studio> studio_;
  Actions actions_;
  StudioSettings settings_;
  bool results_shown_ = false;
  double files_looked_at_ = 0;  ///< s

  // Owned by the composite of elements:
  MenuPopup* popup_ = nullptr;
  MenuBar* menu_ = nullptr;
  ListPanel* list_ = nullptr;
  DescriptorPanel* descriptors_ = nullptr;
  ScenarioView* view_ = nullptr;
  ResultsPanel* results_ = nullptr;
  StatusBar* status_ = nullptr;
  Splitter *list_splitter_ = nullptr, *descriptors_splitter_ = nullptr,
           *results_splitter_ = nullptr;
};

}  // namespace slalom
