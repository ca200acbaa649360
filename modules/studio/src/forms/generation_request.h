#pragma once

#include "forms/made_list.h"

#include <slalom/commands/generate_list.h>

#include <string>

namespace slalom {

/// Defaults of the generation forms: the robot, its sensor and the target list.
struct GenerationDefaults {
  double robot_radius = 0.25;  ///< m
  double sensor_range = 8;     ///< m
  double resolution = 0.05;    ///< m
  ListTarget target;
};

/// A generation requested by the user, with the same input as `slalom-scenarios generate`.
struct GenerationRequest {
  IniFile ini;
  GenerationOptions order;
  std::string file;  ///< of the new list; empty: append to an open list
};

/// Form for families with all their options, number and seed.
FormDescription random_generation_form(const GenerationDefaults& defaults);
/// Form for descriptors with their bins, and the budget of the search.
FormDescription bins_generation_form(const GenerationDefaults& defaults);

/// Throw Error (Usage) with section and key like check_generation(), or when the new list already
/// exists.
GenerationRequest read_random_generation(const FormValues& values);
GenerationRequest read_bins_generation(const FormValues& values);

/// Generates the scenarios; may run in any thread. When `progress` throws to cancel, no file is
/// left. For a generation by bins the report is the table of bins.
MadeList generate(const GenerationRequest& request, const MapLoader& load_map, Progress& progress);

}  // namespace slalom
