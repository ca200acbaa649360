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

/// Visits the default options of a family.
template <typename Options>
void visit_defaults(OptionVisitor& visitor) {
  Options options;
  options.visit(visitor);
}

template <typename Options>
constexpr Family family_of(std::unique_ptr<Generator> (*make)(const IniFile&,
                                                              const GeneratorContext&)) {
  return {Options::kFamily, make, visit_defaults<Options>};
}

/// All families; a new one is registered here.
constexpr Family kFamilies[] = {
    family_of<CellularAutomatonOptions>(make_cellular_automaton),
    family_of<ClutterOptions>(make_clutter),
    family_of<CropOptions>(make_crop),
    family_of<MazeOptions>(make_maze),
    family_of<PerlinOptions>(make_perlin),
    family_of<PoissonForestOptions>(make_poisson_forest),
    family_of<RandomGeneratorOptions>(make_random_generator),
    family_of<RoomsOptions>(make_rooms),
    family_of<TrapsOptions>(make_traps),
};

const Family& family(const std::string& name, const std::string& where) {
  for (const Family& candidate : kFamilies)
    if (name == candidate.name) return candidate;
  const std::vector<std::string> names = generator_names();
  throw usage_error(where, "unknown generator '" + name + "'", expected_name(name, names));
}

}  // namespace

std::vector<std::string> generator_names() {
  std::vector<std::string> names;
  for (const Family& entry : kFamilies) names.emplace_back(entry.name);
  return names;
}

std::unique_ptr<Generator> make_generator(const std::string& name, const IniFile& ini,
                                          const GeneratorContext& context) {
  return family(name, ini.name()).make(ini, context);
}

std::uint64_t source_seed(std::uint64_t seed, const std::string& name) {
  return derive_seed(seed, "scenarios/" + name);
}

void visit_generator_options(const std::string& name, OptionVisitor& visitor) {
  family(name, "generator").visit(visitor);
}

}  // namespace slalom
