#include <slalom/core/error.h>
#include <slalom/gui/display.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/replay_window.h>
#include <slalom/gui/results_panel.h>
#include <slalom/gui/scenario_view.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <iostream>

namespace slalom {
namespace {

constexpr unsigned kWidth = 1180, kHeight = 760;
constexpr int kGap = 4, kLeastResults = 200;
constexpr double kPlayInterval = 0.02, kIdleInterval = 0.5;  // s between frames

}  // namespace

ReplayWindow::ReplayWindow(const Scenario& scenario, const ReplayContent& content)
    : CDisplayWindowGUI(content.title, kWidth, kHeight),
      jobs_(std::make_unique<Jobs>([] { glfwPostEmptyEvent(); })),
      scenes_(std::make_unique<SceneLoader>(*jobs_, content.scene)) {
  setBackground(palette().window);
  view_ = new ScenarioView(this);
  results_ = new ResultsPanel(this);
  results_->on_overlay_changed = [this](std::vector<OverlayTrajectory> runs) {
    view_->set_trajectories(std::move(runs));
  };
  scenes_->on_scene = [this](const ScenePtr& scene) { view_->set_scene(scene); };
  scenes_->on_error = [this](const std::string& message) { view_->set_message(message); };
  results_->set_source(content.source);
  results_->set_message("Measuring clearances ...");
  scenes_->show(scenario);
  load_series(scenario, content);
  setVisible(true);
  arrange();
}

ReplayWindow::~ReplayWindow() {
  jobs_.reset();  // workers end before what they report to
}

void ReplayWindow::load_series(const Scenario& scenario, const ReplayContent& content) {
  jobs_->start(
      "series", "Measure clearances",
      [this, scenario, content](Progress&) -> Jobs::Delivery {
        const World world(scenario, content.scene.resolution);
        auto runs = content.runs;
        for (OverlayRun& run : runs) fill_series(run, world, content.source.robot);
        return [this, runs = std::move(runs)] {
          results_->set_runs(runs);
          results_->replay().seek(0);
          if (starts_by_itself_) results_->replay().play();
        };
      },
      [this](const std::string& message) { results_->set_message(message); });
}

void ReplayWindow::arrange() {
  const int below = std::min(std::max(kLeastResults, height() * 3 / 10), height() / 2);
  view_->setPosition({0, 0});
  view_->setSize({width(), height() - below - kGap});
  results_->setPosition({0, height() - below});
  results_->setSize({width(), below});
  for (nanogui::Widget* element :
       {static_cast<nanogui::Widget*>(view_), static_cast<nanogui::Widget*>(results_)})
    element->performLayout(mNVGContext);
}

void ReplayWindow::performLayout(NVGcontext* ctx) {
  CDisplayWindowGUI::performLayout(ctx);
  if (results_ != nullptr) arrange();
}

bool ReplayWindow::resizeEvent(const nanogui::Vector2i& size) {
  const bool handled = CDisplayWindowGUI::resizeEvent(size);
  if (results_ != nullptr) arrange();
  return handled;
}

bool ReplayWindow::keyboardEvent(int key, int scancode, int action, int modifiers) {
  if (CDisplayWindowGUI::keyboardEvent(key, scancode, action, modifiers)) return true;
  if (key == GLFW_KEY_Q && (modifiers & GLFW_MOD_CONTROL) != 0) {
    glfwSetWindowShouldClose(glfwWindow(), GLFW_TRUE);
    return true;
  }
  return results_->replay().keyboardEvent(key, scancode, action, modifiers);
}

bool ReplayWindow::open_still() const {
  return visible() && glfwWindowShouldClose(mGLFWWindow) == 0;
}

void ReplayWindow::run() {
  while (open_still()) {
    jobs_->poll();
    drawAll();
    glfwWaitEventsTimeout(results_->overlay().clock().playing() ? kPlayInterval : kIdleInterval);
  }
}

void ReplayWindow::run(const std::vector<ScriptCommand>& script, const std::string& name) {
  starts_by_itself_ = false;
  ScriptPlayer player(script, name,
                      {this, [this] { return jobs_->idle(); },
                       [](const std::string& id) {
                         throw usage_error("do " + id, "a replay has no menus", "click or key");
                       },
                       [this](const std::string& path) { save_window_picture(*this, path); },
                       [](const std::string& text) { std::cout << text << "\n"; }});
  while (open_still() && !player.ended()) {
    jobs_->poll();
    drawAll();
    player.step();
    glfwPollEvents();
  }
}

}  // namespace slalom
