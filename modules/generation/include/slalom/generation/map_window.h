// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/core/random.h>
#include <slalom/scenario/occupancy.h>

#include <memory>
#include <string>

namespace slalom {

/// The part of a real map that becomes a scenario.
struct MapWindowOptions {
  std::string map;                 ///< file
  double width = 12, height = 12;  ///< m, of the window; 0: that of the map
  double min_free = 0.3;           ///< minimum fraction of free cells in the window
  double min_occupied = 0.02;      ///< minimum fraction of occupied cells in the window

  void visit(OptionVisitor& v);
};

/// A map from which windows are cut. Unknown cells count as occupied, unless the loader made them
/// free. Windows keep the coordinates of the map.
class MapWindows {
 public:
  MapWindows(Occupancy map, const MapWindowOptions& options);

  /// A random window with the required fractions of free and occupied cells; the best of a bounded
  /// number of draws if none satisfies them.
  Occupancy draw(RandomEngine& engine) const;

  const Occupancy& map() const { return map_; }

 private:
  struct Corner {
    int x, y;
  };
  Corner draw_corner(RandomEngine& engine) const;
  int count_occupied(const Corner& corner) const;
  Occupancy cut(const Corner& corner) const;

  Occupancy map_;
  MapWindowOptions options_;
  int columns_, rows_;  ///< of a window
};

}  // namespace slalom
