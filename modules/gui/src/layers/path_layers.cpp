#include "layers.h"
#include "shapes.h"

#include <slalom/gui/palette.h>

#include <cstdio>

namespace slalom {
namespace {

std::string metres(const char* what, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%s%.2f m", what, value);
  return text;
}

class PathLayer : public SceneLayer {
 public:
  PathLayer(const char* id, const char* title, const nanogui::Color& color, bool on, float width)
      : SceneLayer(id, title, color, on), width_(width) {}

  void draw(const LayerContext& c) override {
    if (const Path* path = path_of(c.scene))
      shapes::polyline(c.ctx, c.view, *path, color(), width_);
  }

 private:
  virtual const Path* path_of(const SceneData& scene) const = 0;

  float width_;
};

class ShortestPathLayer : public PathLayer {
 public:
  ShortestPathLayer() : PathLayer("shortest", "Shortest path", palette().shortest, true, 2.5F) {}

  std::string missing(const SceneData& scene,
                      const std::vector<OverlayTrajectory>&) const override {
    return scene.references ? scene.references->shortest_reason : scene.missing_paths();
  }
  std::string note(const SceneData& scene) const override {
    return path_of(scene) != nullptr ? metres("", scene.references->shortest->length) : "";
  }

 private:
  const Path* path_of(const SceneData& scene) const override {
    return scene.references && scene.references->shortest ? &scene.references->shortest->path
                                                          : nullptr;
  }
};

class SafestPathLayer : public PathLayer {
 public:
  SafestPathLayer() : PathLayer("safest", "Safest path", palette().safest, true, 2.5F) {}

  std::string missing(const SceneData& scene,
                      const std::vector<OverlayTrajectory>&) const override {
    return scene.references ? scene.references->safest_reason : scene.missing_paths();
  }
  std::string note(const SceneData& scene) const override {
    return path_of(scene) != nullptr ? metres("", length(scene.references->safest->path)) : "";
  }

 private:
  const Path* path_of(const SceneData& scene) const override {
    return scene.references && scene.references->safest ? &scene.references->safest->path : nullptr;
  }
};

class PublishedPathLayer : public PathLayer {
 public:
  PublishedPathLayer() : PathLayer("published", "Published path", palette().published, false, 2) {}

  std::string missing(const SceneData& scene,
                      const std::vector<OverlayTrajectory>&) const override {
    return path_of(scene) != nullptr ? "" : "none was published with this scenario";
  }

 private:
  const Path* path_of(const SceneData& scene) const override {
    const PublishedPathPtr& published = scene.scenario().published_path();
    return published ? &published->points : nullptr;
  }
};

}  // namespace

std::unique_ptr<SceneLayer> make_shortest_path_layer() {
  return std::make_unique<ShortestPathLayer>();
}
std::unique_ptr<SceneLayer> make_safest_path_layer() {
  return std::make_unique<SafestPathLayer>();
}
std::unique_ptr<SceneLayer> make_published_path_layer() {
  return std::make_unique<PublishedPathLayer>();
}

}  // namespace slalom
