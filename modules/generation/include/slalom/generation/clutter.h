#pragma once

#include <slalom/generation/ends.h>
#include <slalom/generation/generator.h>
#include <slalom/generation/map_window.h>
#include <slalom/generation/obstacles.h>

namespace slalom {

/// Section [generator.clutter]: a real map with things standing about.
struct ClutterOptions {
  MapWindowOptions window;
  ObstacleOptions obstacles = {3, 15, {0.08, 0.35}, 0.5, 0.3};
  EndsOptions ends = {0.5, 5, 0.5};

  void visit(OptionVisitor& v);
};

/// A random window of the map as a grid, with random discs and polygons about free places of it;
/// start and goal at free places.
std::unique_ptr<Generator> make_clutter(const IniFile& ini, const GeneratorContext& context = {});

}  // namespace slalom
