#pragma once

#include <slalom/map_formats/map_export.h>

namespace slalom {

/// One function per format, see map_export.cpp.
void write_ros_map(const Scenario& scenario, const MapExportOptions& options,
                   const std::string& path);
void write_mrpt_map(const Scenario& scenario, const MapExportOptions& options,
                    const std::string& path);
void write_mvsim_world(const Scenario& scenario, const MapExportOptions& options,
                       const std::string& path);

/// The grid of a scenario, in MRPT's archive format and packed, to a temporary file that is
/// renamed. Throws Error (Job) when it cannot be written.
void write_gridmap(const mrpt::maps::COccupancyGridMap2D& map, const std::string& path);

/// "folder/office" of "folder/office.yaml": the path without a known ending.
std::string without_ending(const std::string& path, const std::string& ending);

}  // namespace slalom
