// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/descriptor_map.h>
#include <slalom/analysis/difficulty.h>
#include <slalom/analysis/history.h>
#include <slalom/analysis/method_ranks.h>
#include <slalom/analysis/performance_profile.h>
#include <slalom/analysis/summary.h>
#include <slalom/io/svg_scene.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// How a figure is printed: a narrow one has its legend below.
struct FigureStyle {
  std::optional<double> width;  ///< millimeters; none: as wide as its parts are by default
  double font_size = 9;         ///< points, of all text
  std::map<std::string, std::string> labels;  ///< what methods are called; others by their names
};

/// Figures for papers: one self-contained SVG element each, on white. Methods have the colors of
/// method_color() by their index in the list given here, as in reports.

/// Performance profiles (Dolan and More 2002) as step curves, with a legend.
std::string profile_figure(const ProfileTable& table, const FigureStyle& style = {});

/// A critical-difference diagram (Demsar 2006): methods at their mean ranks, best on the left; bars
/// join groups that do not differ by the critical difference.
std::string rank_figure(const MethodRanks& ranks, const FigureStyle& style = {});

/// A metric over the bins of a descriptor, one specification of build_cross_tables(): a line per
/// method through its estimates, with their intervals.
std::string bins_figure(const std::vector<CrossTable>& tables, const Column& column,
                        const FigureStyle& style = {});

/// A panel per map: estimates and numbers of values over the bins of two descriptors.
std::string map_figure(const std::vector<DescriptorMap>& maps, const FigureStyle& style = {});

/// The abilities of methods with their intervals beside the numbers of scenarios of each
/// difficulty (Wright map). `methods` have the colors of their places.
std::string difficulty_figure(const DifficultyScale& scale, const std::vector<std::string>& methods,
                              const FigureStyle& style = {});

/// A metric over results in their order, such as those of versions: a line per method through its
/// estimates, with their intervals. `results` are their names.
std::string history_figure(const History& history, const std::string& metric,
                           const std::vector<std::string>& results);

/// A bar per method, divided by the outcomes of its runs, success first.
std::string outcome_figure(const SummaryTable& summary, const FigureStyle& style = {});

/// A box per method: quartiles, median, and whiskers to the 5 % and 95 % quantiles, with the number
/// of runs that have a value. Throws Error (Usage) for an unknown metric.
std::string box_figure(const ResultTable& runs, const std::string& metric,
                       const FigureStyle& style = {});

/// Per method the share of its runs with at most that value; runs without a value count as larger.
/// Throws Error (Usage) for an unknown metric.
std::string distribution_figure(const ResultTable& runs, const std::string& metric,
                                const FigureStyle& style = {});

/// A point per run that has both values, descriptors or metrics. Throws Error (Usage) for unknown
/// ids.
std::string scatter_figure(const ResultTable& runs, const std::string& x, const std::string& y,
                           const FigureStyle& style = {});

/// A scenario with runs in it; max_pixels = 0: as large as three in a row are.
struct ScenarioFigure {
  Scenario scenario;
  SceneOptions options;
};

/// Pictures of scenarios, each with its name, in rows of at most three.
std::string scenario_figure(const std::vector<ScenarioFigure>& scenarios,
                            const FigureStyle& style = {});

}  // namespace slalom
