#include "load_windows.h"

#include <algorithm>

namespace slalom {

MapWindows load_windows(const FamilySection& section, const MapWindowOptions& options,
                        const EndsOptions& ends) {
  section.expect(!options.map.empty(), "map", "names no map", "a map file");
  section.expect(static_cast<bool>(section.context().load_map), "map", "cannot be loaded here",
                 "a program that reads maps");
  section.expect(options.min_free + options.min_occupied <= 1, "min_occupied",
                 "contradicts min_free", "both together at most 1");
  const Scenario map = Scenario::grid(options.map, section.context().load_map(options.map), {}, {});
  MapWindows windows(make_occupancy(map, map.grid_map()->getResolution()), options);
  const Bounds& all = windows.map().bounds();
  section.expect_room(ends, options.width > 0 ? std::min(options.width, all.width()) : all.width(),
                      options.height > 0 ? std::min(options.height, all.height()) : all.height());
  return windows;
}

}  // namespace slalom
