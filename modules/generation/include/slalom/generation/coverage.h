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

/// Section [coverage]: which bins are to be filled, and how long to try.
struct CoverageOptions {
  std::string descriptors;          ///< ids, comma separated: one, or several jointly
  std::string bins = "10";          ///< bins per descriptor, comma separated, or one for all
  int per_bin = 20;                 ///< scenarios wanted in each bin
  double min_difference = 0.05;     ///< between any two scenarios, see difference()
  int budget_evaluations = 200000;  ///< candidates looked at, in all
  double budget_time = 0;           ///< s of wall clock, 0: no limit
  int patience = 1000;              ///< evaluations aimed at a bin since it last got a scenario
  double fresh_share = 0.2;         ///< share of candidates drawn anew from the families
  double min_floor = 4, max_floor = 40;  ///< m, sides of the floor
  double min_distance = 2;               ///< m, straight from start to goal
  int max_obstacles = 5000;              ///< primitives of a scenario

  void visit(OptionVisitor& v);
};

/// One descriptor and the edges of its bins, ascending. Bin i holds [edges[i], edges[i + 1]); the
/// last one also holds its upper edge.
struct CoverageAxis {
  std::string id;
  std::vector<double> edges;
  std::size_t size() const { return edges.size() - 1; }
};

/// What is to be covered, and by which families.
struct CoveragePlan {
  CoverageOptions options;
  std::vector<CoverageAxis> axes;
  std::vector<std::string> families;
  IniFile ini;  ///< options that stand in its [generator.NAME] are kept, the others are varied
};

/// Reads [coverage] (with edges.ID or range.ID for each descriptor) and checks the families.
/// Throws Error (Usage) with file, line and key.
CoveragePlan read_coverage_plan(const IniFile& ini, const std::vector<std::string>& families);

/// For whom scenarios are made, from which seed, and on how many threads.
struct CoverageTask {
  std::uint64_t seed = 1;
  double robot_radius = 0.25;  ///< m
  double sensor_range = 8;     ///< m
  double resolution = 0.05;    ///< m
  int jobs = 1;
  MapLoader load_map = {};
};

/// A certified scenario and the bin it lies in.
struct CoveredScenario {
  Scenario scenario;  ///< named after its bin, "bin_2_4_0007"
  std::vector<GeneratedValue> values;
  std::uint64_t seed = 0;  ///< of the candidate that it was; not enough to draw it again
  std::size_t bin = 0;     ///< index among CoverageResult::bins
};

enum class BinVerdict { Full, Starved, Impossible };
std::string to_string(BinVerdict verdict);  ///< full, starved, impossible

/// How it went with one bin.
struct BinReport {
  std::vector<std::size_t> position;                 ///< along each axis
  std::vector<std::pair<double, double>> intervals;  ///< along each axis
  int wanted = 0, found = 0;
  int effort = 0;  ///< evaluations aimed at it
  BinVerdict verdict = BinVerdict::Starved;
  std::string why;  ///< the proof where impossible, what was tried where starved
};

struct CoverageResult {
  std::vector<CoveredScenario> scenarios;  ///< by bin, then in the order in which they were found
  std::vector<BinReport> bins;             ///< the first axis varies slowest
  int evaluations = 0;
  std::string stopped;     ///< why the search ended
  bool repeatable = true;  ///< false when the wall clock ended it
};

/// Fills the bins with scenarios that are certified solvable and differ by min_difference. The same
/// for any number of threads. Bins that cannot be filled are told in the result, not thrown.
CoverageResult cover(const CoveragePlan& plan, const CoverageTask& task, Progress& progress);

/// The bins as a table for people: wanted, found, effort, verdict and why; for two descriptors also
/// a map of what was found.
std::string render_coverage(const CoveragePlan& plan, const CoverageResult& result);

}  // namespace slalom
