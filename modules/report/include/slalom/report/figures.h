// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/method_ranks.h>
#include <slalom/analysis/performance_profile.h>
#include <slalom/io/svg_scene.h>

#include <string>
#include <vector>

namespace slalom {

/// Figures for papers: one self-contained SVG element each, on white. Methods have the colors of
/// method_color() by their index in the list given here, as in reports.

/// Performance profiles (Dolan and More 2002) as step curves, with a legend.
std::string profile_figure(const ProfileTable& table);

/// A critical-difference diagram (Demsar 2006): methods at their mean ranks, best on the left; bars
/// join groups that do not differ by the critical difference.
std::string rank_figure(const MethodRanks& ranks);

/// A scenario with runs in it.
struct ScenarioFigure {
  Scenario scenario;
  SceneOptions options;
};

/// Pictures of scenarios in rows of `columns`, below each other, each with its name.
std::string scenario_figure(const std::vector<ScenarioFigure>& scenarios, std::size_t columns);

}  // namespace slalom
