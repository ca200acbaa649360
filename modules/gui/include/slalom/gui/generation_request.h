#pragma once

#include <slalom/commands/generate_list.h>
#include <slalom/gui/made_list.h>

#include <string>

namespace slalom {

/// For whom scenarios are generated unless the user says otherwise, and where they go.
struct GenerationDefaults {
  double robot_radius = 0.25;  ///< m
  double sensor_range = 8;     ///< m
  double resolution = 0.05;    ///< m
  ListTarget target;
};

/// What a user asked to be generated: what `slalom-scenarios generate` is told.
struct GenerationRequest {
  IniFile ini;
  GenerationOrder order;
  std::string file;  ///< the new list; empty: they are added to an open one
};

/// Families with all their options, number and seed.
FormDescription random_generation_form(const GenerationDefaults& defaults);
/// Descriptors with their bins, and how long to try.
FormDescription bins_generation_form(const GenerationDefaults& defaults);

/// Throw Error (Usage) with section and key where check_generation() does, or where the new list is
/// there already.
GenerationRequest read_random_generation(const FormValues& values);
GenerationRequest read_bins_generation(const FormValues& values);

/// The work itself, for any thread. When `progress` throws to end it, nothing is left of it. The
/// report is the table of bins where there are some.
MadeList generate(const GenerationRequest& request, const MapLoader& load_map, Progress& progress);

}  // namespace slalom
