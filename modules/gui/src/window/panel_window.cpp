#include "views/form_panel.h"
#include "widgets/drawing.h"
#include "window/script_player.h"

#include <slalom/gui/display.h>
#include <slalom/gui/panel_window.h>

#include <GLFW/glfw3.h>
#include <iostream>

namespace slalom {
namespace {

/// Time between frames without events (s): while a replay plays, and otherwise.
constexpr double kPlayInterval = 0.02, kIdleInterval = 0.5;

}  // namespace

PanelWindow::PanelWindow(const std::string& title, int width, int height, SceneSettings scene,
                         StudioServices services)
    : CDisplayWindowGUI(title, static_cast<unsigned>(width), static_cast<unsigned>(height)),
      studio_(std::make_unique<Studio>(std::move(scene), std::move(services),
                                       [] { glfwPostEmptyEvent(); })) {
  setBackground(draw::nvg(palette().window));
  studio_->notices().observe([this](Change change) {
    if (change == Change::Form) open_form(*this, studio_->notices().take_form());
  });
}

PanelWindow::~PanelWindow() {
  studio_.reset();  // joins the workers before the elements that they report to are destroyed
}

void PanelWindow::show() {
  complete_ = true;
  setVisible(true);
  performLayout(mNVGContext);
}

void PanelWindow::performLayout(NVGcontext* ctx) {
  CDisplayWindowGUI::performLayout(ctx);
  if (complete_) arrange();
}

bool PanelWindow::resizeEvent(const nanogui::Vector2i& size) {
  const bool handled = CDisplayWindowGUI::resizeEvent(size);
  if (complete_) arrange();
  return handled;
}

bool PanelWindow::is_open() const {
  return visible() && glfwWindowShouldClose(mGLFWWindow) == 0;
}

void PanelWindow::frame() {
  studio_->poll();
  drawAll();
}

void PanelWindow::run() {
  while (is_open()) {
    frame();
    const bool playing = studio_->results().overlay().clock().playing();
    glfwWaitEventsTimeout(playing ? kPlayInterval : kIdleInterval);
  }
}

void PanelWindow::run(const std::vector<ScriptCommand>& script, const std::string& name) {
  ScriptPlayer player(script, name,
                      {this, [this] { return studio_->jobs().idle(); },
                       [this](const std::string& id) { run_action(id); },
                       [this](const std::string& path) { save_window_picture(*this, path); },
                       [](const std::string& text) { std::cout << text << "\n"; }});
  while (is_open() && !player.ended()) {
    frame();
    player.step();
    glfwPollEvents();
  }
}

}  // namespace slalom
