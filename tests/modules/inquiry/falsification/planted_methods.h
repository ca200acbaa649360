// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "places.h"

#include <slalom/falsification/trial.h>
#include <slalom/library/library_method.h>

namespace slalom {

/// Follow-the-gap with a planted defect (plugins/planted.cpp).
inline NamedMethod planted(const std::string& defect) {
  return {defect == "none" ? "base" : defect, plugin(kPlantedMethod, {{"defect", defect}}), "test"};
}

/// A method with a planted defect; the one without is the witness.
inline FalsificationSetup planted_setup(const std::string& defect) {
  FalsificationSetup setup;
  setup.run.simulation.max_time = 40;
  setup.method = planted(defect);
  setup.witnesses = {planted("none")};
  return setup;
}

/// A wall with a door, 1.1 m wide, that triggers squeeze and crash, and eleven other obstacles far
/// from the straight line to the goal.
inline Scenario passage() {
  Primitives obstacles;
  obstacles.polygons = {{{{4.9, 0.5}, {5.12, 0.5}, {5.12, 4.45}, {4.9, 4.45}}},
                        {{{4.9, 5.55}, {5.12, 5.55}, {5.12, 9.5}, {4.9, 9.5}}}};
  for (int i = 0; i < 6; ++i) obstacles.discs.push_back({{1.3 + 1.47 * i, 8.7}, 0.21});
  for (int i = 0; i < 5; ++i) {
    const double x = 1.17 + 1.5 * i, y = 1.23;
    obstacles.polygons.push_back({{{x, y}, {x + 0.6, y}, {x + 0.6, y + 0.4}, {x, y + 0.4}}});
  }
  return Scenario::continuous("passage", {0, 0, 10, 10}, obstacles, {1.53, 5, 0.02}, {8.47, 5});
}

}  // namespace slalom
