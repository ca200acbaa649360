#include "layers.h"
#include "shapes.h"

#include <slalom/gui/palette.h>

namespace slalom {
namespace {

/// The robot at the start, and the goal.
class EndsLayer : public SceneLayer {
 public:
  EndsLayer() : SceneLayer("ends", "Start and goal", palette().start, true) {}

  void draw(const LayerContext& c) override {
    const Scenario& scenario = c.scene.scenario();
    const RobotModel& robot = c.scene.settings.robot;
    shapes::goal(c.ctx, c.view, scenario.goal(), robot.radius, palette().goal);
    shapes::robot(c.ctx, c.view, robot.shape(), scenario.start(), palette().start);
  }
};

}  // namespace

std::unique_ptr<SceneLayer> make_ends_layer() {
  return std::make_unique<EndsLayer>();
}

}  // namespace slalom
