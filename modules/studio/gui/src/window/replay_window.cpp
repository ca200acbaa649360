// SPDX-License-Identifier: BSD-3-Clause
#include "views/panels.h"
#include "views/scenario_view.h"
#include "window/script_player.h"

#include <slalom/core/error.h>
#include <slalom/gui/replay_window.h>

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

constexpr int kWidth = 1180, kHeight = 760;
constexpr int kViewGap = 4, kMinResults = 200;

}  // namespace

ReplayWindow::ReplayWindow(const Scenario& scenario, const ReplayContent& content, bool autoplay)
    : PanelWindow(content.title, kWidth, kHeight, content.scene, {}) {
  view_ = new ScenarioView(this, studio(), ScenarioView::Mode::Look);
  results_ = make_results_panel(this, studio());
  studio().results().show_runs(content.source, {}, "Computing clearances ...");
  studio().scenes().show(scenario);
  load_series(scenario, content, autoplay);
  show();
}

void ReplayWindow::load_series(const Scenario& scenario, const ReplayContent& content,
                               bool autoplay) {
  studio().jobs().start(
      "series", "Compute clearances",
      [this, scenario, content, autoplay](Progress&) -> Jobs::Delivery {
        const World world(scenario, content.scene.resolution);
        auto runs = content.runs;
        for (OverlayRun& run : runs) {
          fill_series(run, world, content.source.robot);
          fill_people(run, world, content.source);
        }
        return [this, autoplay, source = content.source, runs = std::move(runs)] {
          studio().results().show_runs(source, runs);
          ReplayClock& clock = studio().results().overlay().clock();
          clock.seek(0);
          if (autoplay) clock.play();
        };
      },
      [this, source = content.source](const std::string& message) {
        studio().results().show_runs(source, {}, message);
      });
}

void ReplayWindow::arrange() {
  const int below = std::min(std::max(kMinResults, height() * 3 / 10), height() / 2);
  const double wide = width(), top = height() - below;
  view_->set_bounds({0, 0, wide, top - kViewGap});
  results_->set_bounds({0, top, wide, static_cast<double>(below)});
  for (Element* element : {view_, results_}) element->performLayout(mNVGContext);
}

bool ReplayWindow::keyboardEvent(int key, int scancode, int action, int modifiers) {
  if (PanelWindow::keyboardEvent(key, scancode, action, modifiers)) return true;
  if (key == GLFW_KEY_Q && (modifiers & GLFW_MOD_CONTROL) != 0) {
    glfwSetWindowShouldClose(glfwWindow(), GLFW_TRUE);
    return true;
  }
  return find_visible_widget(*results_, "replay")->keyboardEvent(key, scancode, action, modifiers);
}

void ReplayWindow::run_action(const std::string& id) {
  throw usage_error("do " + id, "the replay window has no actions", "click or key");
}

}  // namespace slalom
