#pragma once

#include <slalom/generation/ends.h>
#include <slalom/generation/generator.h>
#include <slalom/generation/map_window.h>

namespace slalom {

/// Section [generator.crop]: windows of a real map.
struct CropOptions {
  MapWindowOptions window;
  EndsOptions ends = {0.4, 5, 0.5};

  void visit(OptionVisitor& v);
};

/// A random window of the map as a grid; start and goal at free places in it.
std::unique_ptr<Generator> make_crop(const IniFile& ini, const GeneratorContext& context = {});

}  // namespace slalom
