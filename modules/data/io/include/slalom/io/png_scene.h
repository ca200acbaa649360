// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/svg_scene.h>

#include <mrpt/img/CImage.h>

#include <string>

namespace slalom {

/// Writes an image as a PNG file atomically, using a temporary file that is renamed. Throws Error
/// (Job) when it cannot be written.
void write_png(const mrpt::img::CImage& image, const std::string& path);

/// The same picture as render_svg() as a PNG file. Throws Error (Job) when it cannot be written.
void render_png(const Scenario& scenario, const SceneOptions& options, const std::string& path);

}  // namespace slalom
