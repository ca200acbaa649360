#pragma once

#include <slalom/generation/coverage.h>

#include <memory>

namespace slalom {

/// Draws generators of a family with options from wide ranges about their defaults: lengths scaled
/// with the floor, whose sides lie between min_floor and max_floor, and each number varied by up to
/// a factor of 4, within its range. Options that stand in the .ini are kept as they are; so are
/// texts without a choice, seeds and the cell size.
class OptionDraw {
 public:
  OptionDraw(const CoveragePlan& plan, const MapLoader& load_map);

  /// A generator of a family drawn at random, or null when no valid options were drawn.
  std::unique_ptr<Generator> draw(RandomEngine& engine) const;

 private:
  const CoveragePlan& plan_;
  MapLoader load_map_;  ///< reads each file once
};

}  // namespace slalom
