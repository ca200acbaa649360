// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/generation/avoid.h>
#include <slalom/generation/cellular_automaton.h>
#include <slalom/generation/circle.h>
#include <slalom/generation/clutter.h>
#include <slalom/generation/corridor_flow.h>
#include <slalom/generation/crop.h>
#include <slalom/generation/crossing.h>
#include <slalom/generation/defined_area.h>
#include <slalom/generation/doorway.h>
#include <slalom/generation/follow_path.h>
#include <slalom/generation/generator.h>
#include <slalom/generation/maze.h>
#include <slalom/generation/passage.h>
#include <slalom/generation/people_crossing.h>
#include <slalom/generation/perlin.h>
#include <slalom/generation/poisson_forest.h>
#include <slalom/generation/random_generator.h>
#include <slalom/generation/rooms.h>
#include <slalom/generation/sudden_obstacle.h>
#include <slalom/generation/traps.h>

#include <algorithm>

namespace slalom {
namespace {

struct Family {
  const char* name;
  std::unique_ptr<Generator> (*make)(OptionVisitor& setter, const GeneratorContext& context);
  void (*visit)(OptionVisitor& visitor);
};

template <typename Options>
constexpr Family family_of() {
  return {Options::kFamily,
          [](OptionVisitor& setter, const GeneratorContext& context) {
            Options options;
            options.visit(setter);
            return make_generator(options, context);
          },
          [](OptionVisitor& visitor) {
            Options options;
            options.visit(visitor);
          }};
}

/// All families; a new one is registered here.
// One per line, so that a new one is one.
// clang-format off
constexpr Family kFamilies[] = {
    family_of<AvoidOptions>(),
    family_of<CellularAutomatonOptions>(),
    family_of<CircleOptions>(),
    family_of<CircleCrossingOptions>(),
    family_of<ClutterOptions>(),
    family_of<CropOptions>(),
    family_of<CrossingOptions>(),
    family_of<DefinedAreaOptions>(),
    family_of<DoorwayOptions>(),
    family_of<FollowPathOptions>(),
    family_of<MazeOptions>(),
    family_of<OncomingOptions>(),
    family_of<OvertakingOptions>(),
    family_of<PassageOptions>(),
    family_of<PerlinOptions>(),
    family_of<PoissonForestOptions>(),
    family_of<RandomGeneratorOptions>(),
    family_of<RoomsOptions>(),
    family_of<SquareCrossingOptions>(),
    family_of<SuddenObstacleOptions>(),
    family_of<TrapsOptions>(),
};
// clang-format on

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

std::unique_ptr<Generator> make_generator(const std::string& name, OptionVisitor& setter,
                                          const GeneratorContext& context) {
  return family(name, "generator").make(setter, context);
}

std::unique_ptr<Generator> make_generator(const std::string& name, const IniFile& ini,
                                          const GeneratorContext& context) {
  const Family& named = family(name, ini.name());
  const std::string section = "generator." + name;
  OptionReader reader(ini, section);
  named.visit(reader);
  reader.reject_unknown_keys();
  GeneratorContext located = context;
  located.where = location_in(ini, section);
  return named.make(reader, located);
}

std::uint64_t source_seed(std::uint64_t seed, const std::string& name) {
  return derive_seed(seed, "scenarios/" + name);
}

void visit_generator_options(const std::string& name, OptionVisitor& visitor) {
  family(name, "generator").visit(visitor);
}

}  // namespace slalom
