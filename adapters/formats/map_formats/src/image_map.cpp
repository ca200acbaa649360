// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>

#include <cmath>

namespace slalom {

mrpt::maps::COccupancyGridMap2D read_image_map(const std::string& path,
                                               const ImageMapOptions& options) {
  if (!(options.resolution > 0) || !std::isfinite(options.resolution))
    throw usage_error(path, "the resolution of the image is unknown",
                      "--image-resolution in m per pixel");
  if (options.threshold < 1 || options.threshold > 255)
    throw usage_error(path, "invalid threshold " + std::to_string(options.threshold),
                      "a gray value from 1 to 255");
  const GrayImage image = read_gray_image(path);
  auto map = make_grid_map(image.width, image.height, options.resolution, {0, 0});
  std::size_t i = 0;
  for (int row = 0; row < image.height; ++row)
    for (int x = 0; x < image.width; ++x, ++i) {
      const bool dark = image.pixels[i] * 255 < options.threshold * image.white;
      const float free = dark == options.negate ? 1.0F : 0.0F;
      map.setCell(x, image.height - 1 - row, image.is_transparent(i) ? 0.5F : free);
    }
  return map;
}

}  // namespace slalom
