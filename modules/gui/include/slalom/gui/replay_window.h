#pragma once

#include <slalom/gui/jobs.h>
#include <slalom/gui/overlay_run.h>
#include <slalom/gui/scene_loader.h>
#include <slalom/gui/script_player.h>

#include <mrpt/gui/CDisplayWindowGUI.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

class ResultsPanel;
class ScenarioView;

/// What a ReplayWindow replays.
struct ReplayContent {
  std::string title;             ///< of the window
  SceneSettings scene;           ///< the robot, its sensor, cells
  OverlaySource source;          ///< what the runs are of
  std::vector<OverlayRun> runs;  ///< their series are computed in the window
};

/// A window that replays runs in one scenario: the scenario above, under it the runs with slider
/// and plots. Keys: those of the elements; what these do not use goes to the replay; Ctrl+Q closes.
class ReplayWindow : public mrpt::gui::CDisplayWindowGUI {
 public:
  /// Throws std::runtime_error where there is no display or no OpenGL 3.3.
  ReplayWindow(const Scenario& scenario, const ReplayContent& content);
  ~ReplayWindow() override;

  /// Until the window is closed. Plays from the start by itself, or stands there for the script,
  /// after which it ends; throws what the script does.
  void run();
  void run(const std::vector<ScriptCommand>& script, const std::string& name);

  void performLayout(NVGcontext* ctx) override;
  bool resizeEvent(const nanogui::Vector2i& size) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 private:
  void load_series(const Scenario& scenario, const ReplayContent& content);
  void arrange();
  bool open_still() const;

  std::unique_ptr<Jobs> jobs_;
  std::unique_ptr<SceneLoader> scenes_;
  bool starts_by_itself_ = true;

  // Owned by the composite of elements:
  ScenarioView* view_ = nullptr;
  ResultsPanel* results_ = nullptr;
};

}  // namespace slalom
