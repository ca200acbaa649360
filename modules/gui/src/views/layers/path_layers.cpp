#include "views/layers/layers.h"
#include "views/layers/shapes.h"

#include <cstdio>

namespace slalom {
namespace {

using PathOf = const Path* (*)(const SceneData&);

const Path* shortest_of(const SceneData& scene) {
  const auto& references = scene.references;
  return references && references->shortest ? &references->shortest->path : nullptr;
}

const Path* safest_of(const SceneData& scene) {
  const auto& references = scene.references;
  return references && references->safest ? &references->safest->path : nullptr;
}

const Path* published_of(const SceneData& scene) {
  const PublishedPathPtr& published = scene.scenario().published_path();
  return published ? &published->points : nullptr;
}

std::string meters(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f m", value);
  return text;
}

SceneLayer path_layer(SceneLayer layer, PathOf path_of, float width) {
  layer.draw = [path_of, width, color = layer.color](const LayerContext& c) {
    if (const Path* path = path_of(c.scene)) shapes::polyline(c.ctx, c.view, *path, color, width);
  };
  return layer;
}

}  // namespace

SceneLayer make_shortest_path_layer() {
  SceneLayer layer =
      path_layer({"shortest", "Shortest path", palette().shortest, true}, shortest_of, 2.5F);
  layer.missing_reason = [](const SceneData& scene, const auto&) {
    return scene.references ? scene.references->shortest_reason : scene.missing_paths_reason();
  };
  layer.note = [](const SceneData& scene) {
    return shortest_of(scene) ? meters(scene.references->shortest->length) : "";
  };
  return layer;
}

SceneLayer make_safest_path_layer() {
  SceneLayer layer = path_layer({"safest", "Safest path", palette().safest, true}, safest_of, 2.5F);
  layer.missing_reason = [](const SceneData& scene, const auto&) {
    return scene.references ? scene.references->safest_reason : scene.missing_paths_reason();
  };
  layer.note = [](const SceneData& scene) {
    const Path* path = safest_of(scene);
    return path ? meters(length(*path)) : "";
  };
  return layer;
}

SceneLayer make_published_path_layer() {
  SceneLayer layer =
      path_layer({"published", "Published path", palette().published, false}, published_of, 2);
  layer.missing_reason = [](const SceneData& scene, const auto&) {
    return published_of(scene) ? "" : "no path was published with this scenario";
  };
  return layer;
}

}  // namespace slalom
