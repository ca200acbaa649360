#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/generation/cellular_automaton.h>
#include <slalom/generation/clutter.h>
#include <slalom/generation/crop.h>
#include <slalom/generation/generator.h>
#include <slalom/generation/maze.h>
#include <slalom/generation/perlin.h>
#include <slalom/generation/poisson_forest.h>
#include <slalom/generation/random_generator.h>
#include <slalom/generation/rooms.h>
#include <slalom/generation/traps.h>

#include <algorithm>

namespace slalom {
namespace {

struct Family {
  const char* name;
  std::unique_ptr<Generator> (*make)(const IniFile& ini, const GeneratorContext& context);
  void (*visit)(OptionVisitor& visitor);
};

/// Shows the defaults of a family's options to a visitor.
template <typename Options>
void visit_defaults(OptionVisitor& visitor) {
  Options options;
  options.visit(visitor);
}

/// All families: the one list to add a line to.
constexpr Family kFamilies[] = {
    {"cellular_automaton", make_cellular_automaton, visit_defaults<CellularAutomatonOptions>},
    {"clutter", make_clutter, visit_defaults<ClutterOptions>},
    {"crop", make_crop, visit_defaults<CropOptions>},
    {"maze", make_maze, visit_defaults<MazeOptions>},
    {"perlin", make_perlin, visit_defaults<PerlinOptions>},
    {"poisson_forest", make_poisson_forest, visit_defaults<PoissonForestOptions>},
    {"random", make_random_generator, visit_defaults<RandomGeneratorOptions>},
    {"rooms", make_rooms, visit_defaults<RoomsOptions>},
    {"traps", make_traps, visit_defaults<TrapsOptions>},
};

const Family& family(const std::string& name, const std::string& where) {
  for (const Family& candidate : kFamilies)
    if (name == candidate.name) return candidate;
  const std::vector<std::string> names = generator_names();
  const std::string nearest = nearest_name(name, names);
  throw usage_error(where, "unknown generator '" + name + "'",
                    nearest.empty() ? "one of " + join(names, ", ") : "'" + nearest + "'");
}

}  // namespace

std::vector<std::string> generator_names() {
  std::vector<std::string> names;
  for (const Family& listed : kFamilies) names.emplace_back(listed.name);
  return names;
}

std::unique_ptr<Generator> make_generator(const std::string& name, const IniFile& ini,
                                          const GeneratorContext& context) {
  return family(name, ini.name()).make(ini, context);
}

void visit_generator_options(const std::string& name, OptionVisitor& visitor) {
  family(name, "generator").visit(visitor);
}

}  // namespace slalom
