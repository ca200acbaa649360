#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/core/progress.h>
#include <slalom/core/random.h>
#include <slalom/scenario/scenario.h>

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// Draws candidate scenarios of one family (Strategy). A candidate need not be solvable. Calls from
/// several threads at once are safe; each brings an engine of its own.
class Generator {
 public:
  virtual ~Generator() = default;
  virtual std::string name() const = 0;
  virtual Scenario generate(const std::string& scenario_name, RandomEngine& engine) const = 0;
};

/// Reads a map file as an occupancy grid; given by the program, because formats are adapters.
using MapLoader = std::function<mrpt::maps::COccupancyGridMap2D(const std::string& path)>;

/// What a family is told beside its own options.
struct GeneratorContext {
  /// All lengths among a family's options (those in m) are multiplied by this.
  double length_scale = 1;
  MapLoader load_map = {};  ///< for families on real maps; without it they are refused
};

/// Builds a generator from section "generator.NAME" of an .ini. Throws Error (Usage) naming section
/// and key, or Error (File) for a map that cannot be read.
std::unique_ptr<Generator> make_generator(const std::string& name, const IniFile& ini,
                                          const GeneratorContext& context = {});
std::vector<std::string> generator_names();

/// Shows the options of a family, with their defaults and ranges. Throws Error (Usage).
void visit_generator_options(const std::string& name, OptionVisitor& visitor);

/// For which robot scenarios must be solvable, and how long to try.
struct GenerationTask {
  int count = 60;
  std::uint64_t seed = 1;
  double robot_radius = 0.25;  ///< m
  double resolution = 0.05;    ///< m, cell size of the model in which they are solved
  int attempts_per_scenario = 200;
  std::string name_prefix;  ///< names are PREFIX_0000, PREFIX_0001, ...
};

/// `count` distinct scenarios, each with a certified path for the robot. Scenario i depends only on
/// the generator, the seed and i. Throws Error (Job) saying how many attempts failed and why when
/// one of them cannot be made solvable within the bound.
std::vector<Scenario> generate_solvable(const Generator& generator, const GenerationTask& task,
                                        Progress& progress);

/// Which pairs of start and goal are wanted on a map; each from the first to the second number.
struct TaskLimits {
  double min_distance = 4, max_distance = std::numeric_limits<double>::infinity();  ///< m, straight
  double min_length = 0, max_length = std::numeric_limits<double>::infinity();      ///< m, of P*
  double min_detour = 1, max_detour = std::numeric_limits<double>::infinity();  ///< detour ratio
};

/// Draws `count` distinct start and goal poses on a map such that the robot can go from one to the
/// other, within the limits. The length of P* is that of the exact search, to 1 %. Same bounded
/// attempts and error; Error (Usage) for limits that contradict themselves.
std::vector<Scenario> draw_tasks(const Scenario& map, const GenerationTask& task,
                                 const TaskLimits& limits);

/// The same with a straight distance of at least `min_distance` (m).
std::vector<Scenario> draw_tasks(const Scenario& map, const GenerationTask& task,
                                 double min_distance);

}  // namespace slalom
