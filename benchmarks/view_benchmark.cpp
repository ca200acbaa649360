// SPDX-License-Identifier: BSD-3-Clause
// Frames per second of the scenario view while it is panned and zoomed over a grid of 4,000 x 4,000
// cells in a window of 1280 x 800. With software rendering on a virtual display:
//   LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -s "-screen 0 1280x800x24" view_benchmark

#include "views/scenario_view.h"

#include <slalom/core/random.h>
#include <slalom/scenario/grid_map.h>

#include <mrpt/gui/CDisplayWindowGUI.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

namespace {

using namespace slalom;
using Clock = std::chrono::steady_clock;

/// 200 m x 200 m in cells of 5 cm with 4,000 blocks.
Scenario blocks() {
  auto map = make_grid_map(4000, 4000, 0.05, {0, 0});
  RandomEngine engine(1);
  for (int i = 0; i < 4000; ++i) {
    const auto x = static_cast<int>(uniform_real(engine, 20, 3900));
    const auto y = static_cast<int>(uniform_real(engine, 20, 3900));
    const auto side = static_cast<int>(uniform_real(engine, 5, 60));
    for (int cy = y; cy < y + side; ++cy)
      for (int cx = x; cx < x + side; ++cx) map.setCell(cx, cy, 0.0F);
  }
  return Scenario::grid("blocks", map, {0.5, 0.5, 0}, {199.5, 199.5});
}

class ViewBenchmark {
 public:
  explicit ViewBenchmark(ScenePtr scene)
      : window_("Slalom", 1280, 800),
        studio_({}, {}, {}),
        view_(new ScenarioView(&window_, studio_, ScenarioView::Mode::Look)) {
    view_->setPosition({0, 0});
    view_->setSize({1280, 800});
    view_->set_scene(std::move(scene));
    view_->set_layer("shortest", false);
    window_.drawAll();
    window_.setVisible(true);
    window_.drawAll();
  }

  ScenarioView& view() { return *view_; }

  /// `move` is called before each frame with its number.
  void measure_empty_window() {
    view_->setVisible(false);
    measure("empty window", 100, [](int) {});
    view_->setVisible(true);
  }
  void measure(const char* what, int frames, const std::function<void(int)>& move) {
    window_.drawAll();
    double slowest = 0;
    const auto begin = Clock::now();
    const std::clock_t cpu_begin = std::clock();
    for (int i = 0; i < frames; ++i) {
      const auto from = Clock::now();
      move(i);
      glfwPollEvents();
      window_.drawAll();
      slowest = std::max(slowest, std::chrono::duration<double>(Clock::now() - from).count());
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    std::printf("%-28s %6.1f frames/s, maximum %6.1f ms, processor %5.1f ms per frame\n", what,
                frames / seconds, 1000 * slowest,
                1000.0 * static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC / frames);
  }

 private:
  mrpt::gui::CDisplayWindowGUI window_;
  Studio studio_;
  ScenarioView* view_;  // owned by the window
};

void pan_and_zoom(ViewBenchmark& benchmark) {
  ScenarioView& view = benchmark.view();
  const auto pan = [&view](int i) { view.pan(i % 200 < 100 ? -12 : 12, i % 200 < 100 ? -5 : 5); };
  benchmark.measure("static, complete", 100, [](int) {});
  benchmark.measure("panned, complete", 200, pan);
  view.zoom(5);
  benchmark.measure("panned, 1 pixel per cell", 200, pan);
  view.zoom(6);
  benchmark.measure("panned, 6 pixels per cell", 200, pan);
  view.fit();
  benchmark.measure("zoomed in and out", 200,
                    [&view](int i) { view.zoom(i % 100 < 50 ? 1.08 : 1 / 1.08); });
}

}  // namespace

int main() {
  const auto from = Clock::now();
  const auto progress = slalom::make_silent_progress();
  const slalom::ScenePtr first = slalom::prepare_scene(blocks(), {});
  const auto drawn = Clock::now();
  const slalom::ScenePtr scene = slalom::compute_next_step(first, *progress);
  const auto ready = Clock::now();
  std::printf("scene prepared after %.2f s, clearance after another %.2f s\n",
              std::chrono::duration<double>(drawn - from).count(),
              std::chrono::duration<double>(ready - drawn).count());
  nanogui::init();
  {
    ViewBenchmark benchmark(scene);
    benchmark.measure_empty_window();
    pan_and_zoom(benchmark);
    benchmark.view().set_layer("distance_field", true);
    benchmark.view().set_layer("voronoi", true);
    benchmark.view().fit();
    std::puts("with distance field and Voronoi diagram:");
    pan_and_zoom(benchmark);
  }
  nanogui::shutdown();
}
