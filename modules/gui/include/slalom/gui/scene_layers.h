#pragma once

#include <slalom/gui/overlay_trajectory.h>
#include <slalom/gui/scene.h>
#include <slalom/gui/tile_images.h>

#include <memory>
#include <nanogui/nanogui.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// What layers draw with and from.
struct LayerContext {
  NVGcontext* ctx = nullptr;
  const SceneData& scene;
  const ViewTransform& view;
  const std::vector<OverlayTrajectory>& trajectories;
  std::optional<mrpt::math::TPose2D> scan_pose;  ///< from where the range sensor looks
};

/// One kind of thing that is seen in the scenario view, switched on or off on its own.
class SceneLayer {
 public:
  SceneLayer(std::string id, std::string title, nanogui::Color color, bool on)
      : id_(std::move(id)), title_(std::move(title)), color_(std::move(color)), on_(on) {}
  virtual ~SceneLayer() = default;

  const std::string& id() const { return id_; }
  const std::string& title() const { return title_; }
  const nanogui::Color& color() const { return color_; }  ///< beside its title
  bool on() const { return on_; }
  void set_on(bool on) { on_ = on; }

  /// Why there is nothing to draw; empty when there is.
  virtual std::string missing(const SceneData&, const std::vector<OverlayTrajectory>&) const {
    return "";
  }
  /// What is worth saying about it, with units; empty for nothing.
  virtual std::string note(const SceneData&) const { return ""; }
  /// What it shows as cells, if it does. The view draws those of all layers at once, on the floor
  /// and below all else.
  virtual std::optional<CellPicture> cells(const LayerContext&) { return std::nullopt; }
  /// The rest, in screen coordinates of the view, after cells().
  virtual void draw(const LayerContext&) {}

 private:
  std::string id_, title_;
  nanogui::Color color_;
  bool on_;
};

using SceneLayers = std::vector<std::unique_ptr<SceneLayer>>;

/// All layers in the order in which they are drawn: obstacles, distance_field, voronoi, published,
/// safest, shortest, scan, trajectories, ends.
SceneLayers make_scene_layers();

}  // namespace slalom
