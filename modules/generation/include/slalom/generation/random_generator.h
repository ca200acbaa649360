#pragma once

#include <slalom/generation/ends.h>
#include <slalom/generation/generator.h>
#include <slalom/generation/obstacles.h>

namespace slalom {

/// Section [generator.random]: discs and polygons on a rectangular floor.
struct RandomGeneratorOptions {
  double width = 12, height = 12;  ///< m
  ObstacleOptions obstacles;
  EndsOptions ends;

  void visit(OptionVisitor& v);
};

/// Random discs and polygons, evenly spread; start and goal anywhere at least min_distance apart.
std::unique_ptr<Generator> make_random_generator(const IniFile& ini,
                                                 const GeneratorContext& context = {});

}  // namespace slalom
