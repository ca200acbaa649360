// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/studio/script.h>
#include <slalom/studio/studio.h>

#include <mrpt/gui/CDisplayWindowGUI.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// Runs `show`, which opens windows and returns when they are closed. When no window can be opened
/// (no display, no OpenGL 3.3), throws Error (Job) naming `program` and the `alternative`, e.g.
/// "xvfb-run -a PROGRAM". Errors thrown by `show` are passed on.
void with_display(const std::string& program, const std::string& alternative,
                  const std::function<void()>& show);

/// A window of panels that display a Studio. Shows the dialogs of the studio, runs until it is
/// closed, and plays scripts.
class PanelWindow : public mrpt::gui::CDisplayWindowGUI {
 public:
  ~PanelWindow() override;
  Studio& studio() { return *studio_; }
  const Studio& studio() const { return *studio_; }
  void run();  ///< until the window is closed
  /// Runs until the script ends or the window is closed. Throws the errors of the script.
  void run(const std::vector<ScriptCommand>& script, const std::string& name);

  // Functions of nanogui:
  void draw(NVGcontext* ctx) override;
  void performLayout(NVGcontext* ctx) override;
  bool resizeEvent(const nanogui::Vector2i& size) override;

 protected:
  /// Throws std::runtime_error without a display or OpenGL 3.3. The window appears with show().
  PanelWindow(const std::string& title, int width, int height, SceneSettings scene,
              StudioServices services);
  void show();  ///< after all panels were made; not larger than the screen
  /// Screen pixels per pixel of the layout; 0 for that of the desktop. Keeps the size in pixels of
  /// the layout.
  void set_scale(double scale);
  virtual void arrange() = 0;
  virtual void update();                               ///< before each frame: polls the studio
  virtual void run_action(const std::string& id) = 0;  ///< of a script

 private:
  bool is_open() const;
  void draw_unseen();
  void fit_screen();

  std::unique_ptr<Studio> studio_;
  bool complete_ = false;  ///< all panels were made
  bool seen_ = true;       ///< the frame that is drawn
};

}  // namespace slalom
