// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/core/progress.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/generation/generator.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// Section [coverage]: the bins to fill and the search budget.
struct CoverageOptions {
  std::string descriptors;                 ///< ids, comma separated: one, or several jointly
  std::string bins = "10";                 ///< bins per descriptor, comma separated, or one for all
  int per_bin = 20;                        ///< scenarios wanted in each bin
  double min_difference = 0.05;            ///< between any two scenarios, see difference()
  int budget_evaluations = 200000;         ///< candidates evaluated in total
  double budget_time = 0;                  ///< s, wall-clock time; 0: unlimited
  int patience = 1000;                     ///< evaluations per bin since its last accepted scenario
  double fresh_fraction = 0.2;             ///< fraction of candidates generated without a parent
  double min_extent = 4, max_extent = 40;  ///< m, side lengths of the workspace
  double min_distance = 2;                 ///< m, straight-line distance from start to goal
  int max_obstacles = 5000;                ///< primitives of a scenario

  void visit(OptionVisitor& v);
};

/// One descriptor and the edges of its bins, ascending. Bin i holds [edges[i], edges[i + 1]); the
/// last one also holds its upper edge.
struct CoverageAxis {
  std::string id;
  std::vector<double> edges;
  std::size_t size() const { return edges.size() - 1; }
};

/// The bins to cover and the generators to use.
struct CoveragePlan {
  CoverageOptions options;
  std::vector<CoverageAxis> axes;
  std::vector<std::string> families;
  IniFile ini;  ///< options set in its [generator.NAME] are fixed, the others are varied
};

/// Reads [coverage] (with edges.ID or range.ID for each descriptor) and checks the families.
/// Throws Error (Usage) with file, line and key.
CoveragePlan read_coverage_plan(const IniFile& ini, const std::vector<std::string>& families);

/// Seed, robot, sensor and number of threads of a coverage run.
struct CoverageSettings {
  std::uint64_t seed = 1;
  double robot_radius = 0.25;  ///< m, of the disc, or of the enclosing disc of a polygon
  /// A polygon that rotates in place, as in GenerationSettings; values are those of its shape.
  std::optional<Footprint> footprint = std::nullopt;
  double sensor_range = 8;   ///< m
  double resolution = 0.05;  ///< m
  int jobs = 1;
  MapLoader load_map = {};
  WalkerOptions walkers = {};  ///< added to each candidate without a parent
  PeopleOptions people = {};   ///< likewise
  /// A search that was interrupted, as `keep` got it; it is repeated without the evaluations that
  /// gave nothing.
  std::string known = {};
  /// Called about every second, between batches of 24 candidates, with a letter for each of them.
  std::function<void(const std::string& evaluations)> keep = {};
};

/// A certified scenario and its bin.
struct CoveredScenario {
  Scenario scenario;  ///< named after its bin, "bin_2_4_0007"
  std::vector<KeyedValue> values;
  std::uint64_t seed = 0;  ///< of its candidate; not sufficient to reproduce it
  std::size_t bin = 0;     ///< index among CoverageResult::bins
};

enum class BinVerdict { Full, Incomplete, Impossible };
constexpr auto enum_names(BinVerdict) {
  return std::array{"full", "incomplete", "impossible"};
}

/// The result for one bin.
struct BinReport {
  std::vector<std::size_t> position;                 ///< along each axis
  std::vector<std::pair<double, double>> intervals;  ///< along each axis
  int wanted = 0, found = 0;
  int effort = 0;  ///< evaluations that targeted this bin
  BinVerdict verdict = BinVerdict::Incomplete;
  std::string reason;  ///< the proof if impossible, what was tried if incomplete
};

struct CoverageResult {
  std::vector<CoveredScenario> scenarios;  ///< by bin, then in the order of discovery
  std::vector<BinReport> bins;             ///< the first axis varies slowest
  int evaluations = 0;
  std::string stopped;     ///< why the search ended
  bool repeatable = true;  ///< false if the wall-clock limit ended the search
};

/// Fills the bins with scenarios that are certified solvable and differ by min_difference. The
/// result does not depend on the number of threads. Bins that cannot be filled are reported in the
/// result, not as errors.
CoverageResult cover(const CoveragePlan& plan, const CoverageSettings& settings,
                     Progress& progress);

/// The bins as a text table: wanted, found, effort, verdict and reason; for two descriptors also a
/// map of the numbers found.
std::string render_coverage(const CoveragePlan& plan, const CoverageResult& result);

}  // namespace slalom
