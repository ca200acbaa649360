#include "views/layers/layers.h"
#include "views/layers/shapes.h"
#include "widgets/drawing.h"

#include <nanovg.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

void draw_run_line(const LayerContext& c, const OverlayTrajectory& run) {
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
  nvgFillColor(c.ctx, draw::nvg(outcome_color(run.outcome)));
  nvgFill(c.ctx);
  nvgStrokeColor(c.ctx, draw::nvg(run.color));
  nvgStrokeWidth(c.ctx, 2);
  nvgStroke(c.ctx);
}

void draw_run_robot(const LayerContext& c, const OverlayTrajectory& run) {
  if (run.scan && run.scan->size() > 1) {
    std::vector<TPoint2D> fan = {{run.pose.x, run.pose.y}};
    fan.insert(fan.end(), run.scan->begin(), run.scan->end());
    shapes::fill_polygon(c.ctx, c.view, fan, faded(run.color, 0.15));
  }
  const Footprint footprint = run.footprint.value_or(c.scene.settings.robot.shape());
  shapes::robot(c.ctx, c.view, footprint, run.pose, run.color);
}

}  // namespace

/// The runs in the colors of their methods, bold up to the time of the replay, each end marked in
/// the color of its outcome, and the robots at the time of the replay.
SceneLayer make_trajectories_layer() {
  SceneLayer layer{"trajectories", "Trajectories", method_line_color(0), true};
  layer.draw = [](const LayerContext& c) {
    for (const OverlayTrajectory& run : c.trajectories) draw_run_line(c, run);
    for (const OverlayTrajectory& run : c.trajectories) draw_run_robot(c, run);
  };
  layer.missing_reason = [](const SceneData&, const std::vector<OverlayTrajectory>& runs) {
    return runs.empty() ? "no runs are selected" : "";
  };
  return layer;
}

}  // namespace slalom
