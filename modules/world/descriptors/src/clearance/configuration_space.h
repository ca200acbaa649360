// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/descriptors/descriptor.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// F_C by cells: the number of collision-free headings at the center of each cell, out of
/// `headings` equally spaced ones. A disc has one heading.
struct FreeHeadings {
  int headings = 1;
  std::vector<std::uint8_t> free;  ///< row-major
};

FreeHeadings free_headings(const DescriptorContext& context);

}  // namespace slalom
