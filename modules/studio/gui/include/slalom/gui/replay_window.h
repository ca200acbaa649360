// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/gui/panel_window.h>

#include <string>
#include <vector>

namespace slalom {

class Element;

/// Content of a ReplayWindow.
struct ReplayContent {
  std::string title;             ///< of the window
  SceneSettings scene;           ///< robot, sensor, resolution
  OverlaySource source;          ///< origin of the runs
  std::vector<OverlayRun> runs;  ///< their series are computed in the window
};

/// A window that replays runs in one scenario: the scenario above the runs with slider and plots.
/// Keys: those of the elements; keys that they do not handle go to the replay; Ctrl+Q closes.
class ReplayWindow : public PanelWindow {
 public:
  /// Throws std::runtime_error if there is no display or no OpenGL 3.3. With `autoplay` the replay
  /// starts by itself; otherwise it is paused at the start.
  ReplayWindow(const Scenario& scenario, const ReplayContent& content, bool autoplay);

  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 private:
  void load_series(const Scenario& scenario, const ReplayContent& content, bool autoplay);
  void arrange() override;
  void run_action(const std::string& id) override;

  // Owned by the composite of elements:
  Element *view_ = nullptr, *results_ = nullptr;
};

}  // namespace slalom
