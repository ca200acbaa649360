#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/progress.h>
#include <slalom/generation/coverage.h>
#include <slalom/generation/generator.h>
#include <slalom/io/scenario_list.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// What the .ini of a generation leaves open.
struct GenerationOrder {
  std::uint64_t seed = 1;
  int jobs = 1;                          ///< threads; the list is the same for any number
  std::vector<std::string> descriptors;  ///< to compute and keep at once; not with [coverage]
};

/// How covering bins went, where the .ini has [coverage].
struct GeneratedBins {
  CoveragePlan plan;
  CoverageResult result;
};

/// Appends to `list` what the .ini asks for: [scenarios] as stream_scenarios() reads it, or filled
/// bins where there is a section [coverage]; for [robot] and [sensor]. Note "origin" keeps the seed
/// and the .ini. Throws Error as those do, and whatever `progress` throws to end it; the list then
/// has part of the scenarios.
std::optional<GeneratedBins> generate_list(ScenarioList& list, const IniFile& ini,
                                           const GenerationOrder& order, const MapLoader& load_map,
                                           Progress& progress);

/// Throws Error (Usage) where generate_list() would at once: for wrong sections, keys and values.
/// Reads no maps.
void check_generation(const IniFile& ini, const GenerationOrder& order);

}  // namespace slalom
