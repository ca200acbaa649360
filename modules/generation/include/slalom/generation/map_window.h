#pragma once

#include <slalom/core/options.h>
#include <slalom/core/random.h>
#include <slalom/scenario/occupancy.h>

#include <memory>
#include <string>

namespace slalom {

/// Which part of a real map a scenario shows.
struct MapWindowOptions {
  std::string map;                 ///< file
  double width = 12, height = 12;  ///< m, of the window; 0: as large as the map
  double min_free = 0.3;           ///< least share of free cells in the window
  double min_occupied = 0.02;      ///< least share of occupied cells in the window

  void visit(OptionVisitor& v);
};

/// A map from which windows are cut. Unknown cells count as occupied, unless the loader made them
/// free. Places keep their coordinates.
class MapWindows {
 public:
  MapWindows(Occupancy map, const MapWindowOptions& options);

  /// A random window whose shares of free and occupied cells are as wanted; the best of many that
  /// were drawn where none is.
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
