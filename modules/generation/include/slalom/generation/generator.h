// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/core/progress.h>
#include <slalom/core/random.h>
#include <slalom/robot/footprint.h>
#include <slalom/scenario/scenario.h>

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Generates candidate scenarios of one family (Strategy). A candidate need not be solvable.
/// Thread-safe if each thread uses its own engine.
class Generator {
 public:
  virtual ~Generator() = default;
  virtual std::string name() const = 0;
  virtual Scenario generate(const std::string& scenario_name, RandomEngine& engine) const = 0;
};

/// Reads a map file as an occupancy grid; provided by the program, because formats are adapters.
using MapLoader = std::function<mrpt::maps::COccupancyGridMap2D(const std::string& path)>;

/// Inputs of a generator in addition to its own options.
struct GeneratorContext {
  /// Factor for all lengths (options in m) of the generator.
  double length_scale = 1;
  MapLoader load_map = {};    ///< required by generators on real maps
  OptionLocation where = {};  ///< of the options, for errors; empty: "generator.FAMILY.KEY"
};

/// Creates a generator from section "generator.NAME" of an .ini. Throws Error (Usage) with section
/// and key, or Error (File) for an unreadable map.
std::unique_ptr<Generator> make_generator(const std::string& name, const IniFile& ini,
                                          const GeneratorContext& context = {});
/// Creates a generator from its default options, as changed by `setter`. A C++ program passes the
/// options themselves: make_generator(MazeOptions()), in maze.h.
std::unique_ptr<Generator> make_generator(const std::string& name, OptionVisitor& setter,
                                          const GeneratorContext& context = {});
std::vector<std::string> generator_names();

/// Visits the options of a generator with their defaults and ranges. Throws Error (Usage).
void visit_generator_options(const std::string& name, OptionVisitor& visitor);

/// The seed of one source of scenarios: a map or a family, by name.
std::uint64_t source_seed(std::uint64_t seed, const std::string& name);

/// The robot for which scenarios must be solvable, and the number of attempts.
struct GenerationSettings {
  int count = 60;
  std::uint64_t seed = 1;
  double robot_radius = 0.25;  ///< m, of the disc, or of the enclosing disc of a polygon
  /// A polygon that rotates in place: scenarios with a path for it count as solvable, also where
  /// its enclosing disc has none.
  std::optional<Footprint> footprint = std::nullopt;
  double resolution = 0.05;  ///< m, cell size of the world model in which paths are searched
  int attempts_per_scenario = 200;
  std::string name_prefix;     ///< names are PREFIX_0000, PREFIX_0001, ...
  bool goal_headings = false;  ///< goals have random headings, from a random stream of their own
};

/// `count` distinct scenarios, each with a certified path for the robot, and one over cell centers:
/// none is solvable to rounding errors only. Scenario i depends only on the generator, the seed and
/// i. Throws Error (Job) with the number and the reasons of the failed attempts if
/// attempts_per_scenario do not suffice.
std::vector<Scenario> generate_solvable(const Generator& generator,
                                        const GenerationSettings& settings, Progress& progress);

/// Constraints on pairs of start and goal on a map, as closed intervals.
struct TaskConstraints {
  double min_distance = 4, max_distance = std::numeric_limits<double>::infinity();  ///< m, straight
  double min_length = 0, max_length = std::numeric_limits<double>::infinity();      ///< m, of P*
  double min_detour = 1, max_detour = std::numeric_limits<double>::infinity();  ///< detour ratio
};

/// Samples `count` distinct pairs of start pose and goal on a map, each with a collision-free path
/// and within the limits. Attempts and errors as in generate_solvable(); Error (Usage) for
/// contradictory limits, or a distance that is larger than the map.
std::vector<Scenario> sample_tasks(const Scenario& map, const GenerationSettings& settings,
                                   const TaskConstraints& limits);

/// The same with a straight-line distance of at least `min_distance` (m).
std::vector<Scenario> sample_tasks(const Scenario& map, const GenerationSettings& settings,
                                   double min_distance);

}  // namespace slalom
