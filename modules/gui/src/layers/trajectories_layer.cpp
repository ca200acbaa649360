#include "layers.h"
#include "shapes.h"

#include <slalom/gui/palette.h>

#include <algorithm>
#include <nanovg.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Driven runs in the colours of their methods, strong as far as the replay has come, each end
/// marked in the colour of its outcome, and the robots at the instant of the replay.
class TrajectoriesLayer : public SceneLayer {
 public:
  TrajectoriesLayer() : SceneLayer("trajectories", "Trajectories", method_line_color(0), true) {}

  std::string missing(const SceneData&,
                      const std::vector<OverlayTrajectory>& trajectories) const override {
    return trajectories.empty() ? "no runs are chosen" : "";
  }

  void draw(const LayerContext& c) override {
    for (const OverlayTrajectory& run : c.trajectories) draw_line(c, run);
    for (const OverlayTrajectory& run : c.trajectories) draw_robot(c, run);
  }

 private:
  static void draw_line(const LayerContext& c, const OverlayTrajectory& run) {
    Path path = run.trajectory->path();
    const TPoint2D end = c.view.to_screen(path.back());
    shapes::polyline(c.ctx, c.view, path, run.color, 1.5F);
    path.resize(run.sample + 1);
    path.emplace_back(run.pose.x, run.pose.y);
    shapes::polyline(c.ctx, c.view, path, run.color, 4);
    constexpr float kHalf = 5;
    nvgBeginPath(c.ctx);
    nvgRect(c.ctx, static_cast<float>(end.x) - kHalf, static_cast<float>(end.y) - kHalf, 2 * kHalf,
            2 * kHalf);
    nvgFillColor(c.ctx, outcome_color(run.outcome));
    nvgFill(c.ctx);
    nvgStrokeColor(c.ctx, run.color);
    nvgStrokeWidth(c.ctx, 2);
    nvgStroke(c.ctx);
  }

  static void draw_robot(const LayerContext& c, const OverlayTrajectory& run) {
    if (run.scan && run.scan->size() > 1) {
      std::vector<TPoint2D> fan = {{run.pose.x, run.pose.y}};
      fan.insert(fan.end(), run.scan->begin(), run.scan->end());
      shapes::fill_polygon(c.ctx, c.view, fan, shapes::faded(run.color, 0.15F));
    }
    const Footprint footprint = run.footprint.value_or(c.scene.settings.robot.shape());
    shapes::robot(c.ctx, c.view, footprint, run.pose, run.color);
  }
};

}  // namespace

std::unique_ptr<SceneLayer> make_trajectories_layer() {
  return std::make_unique<TrajectoriesLayer>();
}

}  // namespace slalom
