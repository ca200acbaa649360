#pragma once

#include <slalom/core/options.h>

#include <string>

namespace slalom {

/// What the window remembers from one day to the next, section [window] of its settings file.
struct StudioSettings {
  int width = 1280, height = 800;  ///< pixels
  int list_width = 320;            ///< pixels
  int descriptors_height = 270;    ///< pixels
  int results_height = 230;        ///< pixels
  bool legend = true;              ///< of the scenario view, open
  std::string layers = "obstacles,shortest,safest,scan,trajectories,ends";  ///< that are on

  void visit(OptionVisitor& v);
};

/// Reads the file; the defaults where there is none. Throws Error for what cannot be used.
StudioSettings read_studio_settings(const std::string& path);
/// Writes the file and the folder that it is in. Throws Error (Job) when it cannot.
void write_studio_settings(const StudioSettings& settings, const std::string& path);

}  // namespace slalom
