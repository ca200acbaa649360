#pragma once

#include <slalom/descriptors/descriptor.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// F_C by cells: in how many of `headings` headings, even round the circle, the robot is free when
/// it stands at the centre of a cell. A disc has one heading.
struct FreeHeadings {
  int headings = 1;
  std::vector<std::uint8_t> free;  ///< row-major
};

FreeHeadings free_headings(const DescriptorContext& context);

}  // namespace slalom
