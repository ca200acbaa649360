// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "temporary_folder.h"

#include <slalom/core/random.h>
#include <slalom/scenario/occupancy.h>

#include <string>

namespace slalom {

/// A scenario with random discs and polygons.
inline Scenario sample_scenario(std::uint64_t seed, const std::string& name = "sample") {
  RandomEngine engine(seed);
  Primitives obstacles;
  for (int i = 0; i < 4; ++i)
    obstacles.discs.push_back(
        {{uniform_real(engine, 2, 8), uniform_real(engine, 2, 8)}, uniform_real(engine, 0.1, 0.5)});
  const double x = uniform_real(engine, 3, 6);
  obstacles.polygons.push_back({{{x, 4}, {x + 1, 4}, {x + 0.3, 4.3}, {x, 5}}});
  return Scenario::continuous(name, {0, 0, 10, 10}, obstacles, {1, 1, 0.1 + 0.2}, {9, 9});
}

/// The same in another representation, 0.1 m cells or spacing.
inline Scenario sample_as(Representation to, std::uint64_t seed = 1) {
  return convert(sample_scenario(seed), to, 0.1);
}

/// The same with a published path.
inline Scenario sample_with_path(Representation to) {
  return sample_as(to).with_published_path(std::make_shared<PublishedPath>(
      PublishedPath{{{1, 1}, {1, 1}, {5.1, 5}, {9, 9}}, {0, 0, 10, 9}, 0.5}));
}

/// Two movers: one that loops, one that vanishes.
inline Movers sample_movers() {
  return {{"round # 1", 0.3, {{-1, {3, 1}}, {2.5, {4, 1}}, {6, {3, 1}}}, MoverEnd::Loop},
          {"2", 0.1 + 0.2, {{0, {8, 2}}, {7, {8, 9}}}, MoverEnd::Vanish}};
}

/// Two people: one with a via point, one who walks to and fro from 2.5 s on.
inline People sample_people() {
  return {{"anna # 1", 0.25, 0.1 + 0.2, {1, 3}, {{2, 9}, {9, 9}}, 0, PersonEnd::Vanish},
          {"ben", 0.3, 1.1, {9, 1}, {{1, 1}}, 2.5, PersonEnd::Return}};
}

}  // namespace slalom
