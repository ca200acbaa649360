// Frames per second of the scenario view while it is panned and zoomed over a grid of 4,000 x 4,000
// cells in a window of 1280 x 800. With software rendering under a virtual screen:
//   LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -s "-screen 0 1280x800x24" view_benchmark

#include <slalom/core/random.h>
#include <slalom/gui/scenario_view.h>
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

/// 200 m x 200 m of 5 cm with 4,000 blocks.
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

class Bench {
 public:
  explicit Bench(ScenePtr scene) : window_("Slalom", 1280, 800), view_(new ScenarioView(&window_)) {
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
    measure("nothing drawn", 100, [](int) {});
    view_->setVisible(true);
  }
  void measure(const char* what, int frames, const std::function<void(int)>& move) {
    window_.drawAll();
    double slowest = 0;
    const auto begin = Clock::now();
    const std::clock_t worked = std::clock();
    for (int i = 0; i < frames; ++i) {
      const auto from = Clock::now();
      move(i);
      glfwPollEvents();
      window_.drawAll();
      slowest = std::max(slowest, std::chrono::duration<double>(Clock::now() - from).count());
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    std::printf("%-28s %6.1f frames/s, slowest %6.1f ms, processor %5.1f ms a frame\n", what,
                frames / seconds, 1000 * slowest,
                1000.0 * static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC / frames);
  }

 private:
  mrpt::gui::CDisplayWindowGUI window_;
  ScenarioView* view_;  // the window's
};

void pan_and_zoom(Bench& bench) {
  ScenarioView& view = bench.view();
  const auto pan = [&view](int i) { view.pan(i % 200 < 100 ? -12 : 12, i % 200 < 100 ? -5 : 5); };
  bench.measure("standing still, all of it", 100, [](int) {});
  bench.measure("panned, all of it", 200, pan);
  view.zoom(5);
  bench.measure("panned, a pixel a cell", 200, pan);
  view.zoom(6);
  bench.measure("panned, six pixels a cell", 200, pan);
  view.fit();
  bench.measure("zoomed in and out", 200,
                [&view](int i) { view.zoom(i % 100 < 50 ? 1.08 : 1 / 1.08); });
}

}  // namespace

int main() {
  const auto from = Clock::now();
  const auto progress = slalom::make_silent_progress();
  const slalom::ScenePtr first = slalom::prepare_scene(blocks(), {});
  const auto drawn = Clock::now();
  const slalom::ScenePtr scene = slalom::next_step(first, *progress);
  const auto ready = Clock::now();
  std::printf("made and ready to be drawn after %.2f s, clearance after %.2f s more\n",
              std::chrono::duration<double>(drawn - from).count(),
              std::chrono::duration<double>(ready - drawn).count());
  nanogui::init();
  {
    Bench bench(scene);
    bench.measure_empty_window();
    pan_and_zoom(bench);
    bench.view().set_layer("distance_field", true);
    bench.view().set_layer("voronoi", true);
    bench.view().fit();
    std::puts("with the distance field and the Voronoi diagram:");
    pan_and_zoom(bench);
  }
  nanogui::shutdown();
}
