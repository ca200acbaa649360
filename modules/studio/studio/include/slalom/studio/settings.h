// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/studio/palette.h>

#include <array>
#include <string>

namespace slalom {

/// Absolute paths of the lists (.scenarios) and results (.results) that were opened last, the
/// latest first; empty ones at the end.
using RecentFiles = std::array<std::string, 8>;

/// Puts a file first. Ignores files with other extensions, and paths that an .ini cannot hold.
void remember_file(RecentFiles& files, const std::string& path);

/// Window layout and recent files that are kept between sessions: section [window] of the settings
/// file.
struct StudioSettings {
  double scale = 0;                ///< screen pixels per pixel of the layout; 0: as the desktop
  int width = 1280, height = 800;  ///< pixels
  int list_width = 330;            ///< pixels
  int descriptors_height = 260;    ///< pixels
  int results_height = 220;        ///< pixels
  Theme theme = Theme::Dark;
  bool grid = false;   ///< of pictures, in place of a list with texts
  bool legend = true;  ///< of the scenario view, whether it is open
  std::string layers = "obstacles,shortest,safest,scan,trajectories,start_goal";  ///< visible
  RecentFiles recent;

  void visit(OptionVisitor& v);
};

/// The scales that a window can have.
constexpr double kMinScale = 0.5, kMaxScale = 4;

/// Reads the file; returns the defaults if it does not exist. Throws Error for invalid settings.
StudioSettings read_studio_settings(const std::string& path);
/// Writes the file and creates its folder if needed. Throws Error (Job).
void write_studio_settings(const StudioSettings& settings, const std::string& path);

}  // namespace slalom
