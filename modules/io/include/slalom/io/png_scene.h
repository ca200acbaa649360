#pragma once

#include <slalom/io/svg_scene.h>

#include <string>

namespace slalom {

/// The same picture as render_svg() as a PNG file. Throws Error (Job) when it cannot be written.
void render_png(const Scenario& scenario, const SceneOptions& options, const std::string& path);

}  // namespace slalom
