// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "places.h"

namespace slalom {

/// A method with a planted defect, and the same one without it.
inline const std::string kPlantedCampaign = R"([campaign]
name    = planted
seed    = 1
methods = squeeze, base
[scenarios]
generator = random
[simulation]
max_time = 40
[method.squeeze]
adapter = library
plugin  = )" + kPlantedMethod + R"(
defect  = squeeze
[method.base]
adapter = library
plugin  = )" + kPlantedMethod + "\n";

/// A wall with a door that triggers the defect, and obstacles that do not matter.
constexpr char kPlantedPassage[] = R"(name: "passage"
representation: continuous
bounds: [0, 0, 10, 10]
start: [1.53, 5, 0.02]
goal: [8.47, 5]
discs:
  - [1.3, 8.7, 0.21]
  - [2.8, 8.7, 0.21]
  - [7.1, 8.7, 0.21]
  - [2.2, 1.3, 0.3]
polygons:
  - [[4.9, 0.5], [5.12, 0.5], [5.12, 4.45], [4.9, 4.45]]
  - [[4.9, 5.55], [5.12, 5.55], [5.12, 9.5], [4.9, 9.5]]
)";

}  // namespace slalom
