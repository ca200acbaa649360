// SPDX-License-Identifier: BSD-3-Clause
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

/// Writes a grid in MRPT's archive format, gzip compressed, atomically. Throws Error (Job) if it
/// cannot be written.
void write_gridmap(const mrpt::maps::COccupancyGridMap2D& map, const std::string& path);

/// The path without the given extension: "folder/office" for "folder/office.yaml".
std::string without_extension(const std::string& path, const std::string& ending);

}  // namespace slalom
