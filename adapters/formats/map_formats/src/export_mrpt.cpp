// SPDX-License-Identifier: BSD-3-Clause
#include "map_writers.h"

#include <slalom/core/error.h>
#include <slalom/core/temporary_file.h>
#include <slalom/map_formats/map_task.h>
#include <slalom/scenario/occupancy.h>

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>

namespace slalom {

void write_gridmap(const mrpt::maps::COccupancyGridMap2D& map, const std::string& path) {
  TemporaryFile temporary(path);
  try {
    mrpt::io::CFileGZOutputStream file;
    if (!file.open(temporary.name())) throw std::runtime_error("cannot be created");
    mrpt::serialization::archiveFrom(file) << map;
    file.close();
  } catch (const std::exception& e) {
    throw job_error(path, "cannot be written (" + reason_of(e) + ")", "a writable path");
  }
  temporary.publish();
}

void write_mrpt_map(const Scenario& scenario, const MapExportOptions& options,
                    const std::string& path) {
  const Scenario grid = convert(scenario, Representation::Grid, options.resolution);
  write_gridmap(*grid.grid_map(), path);
  write_map_task(grid, path);
}

}  // namespace slalom
