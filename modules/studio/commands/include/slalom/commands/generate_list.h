// SPDX-License-Identifier: BSD-3-Clause
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

/// Settings of a generation that are not in its .ini.
struct GenerationOptions {
  std::uint64_t seed = 1;
  int jobs = 1;                          ///< threads; the list is the same for any number
  std::vector<std::string> descriptors;  ///< to compute and store; not with [coverage]
};

/// The result of a coverage generation, for an .ini with [coverage].
struct GeneratedBins {
  CoveragePlan plan;
  CoverageResult result;
};

/// Appends the scenarios of the .ini to `list`: those of [scenarios], see stream_scenarios(), or
/// those of a coverage generation if there is a section [coverage]; for [robot] and [sensor].
/// Stores the seed and the .ini as note "origin". Throws the errors of these, and any exception
/// that `progress` throws to cancel; the list then contains part of the scenarios. They are stored
/// about every second, with a note of where the generation is: it is continued if it is called with
/// that list and the same .ini and options again, and the result is the same.
std::optional<GeneratedBins> generate_list(ScenarioList& list, const IniFile& ini,
                                           const GenerationOptions& options,
                                           const MapLoader& load_map, Progress& progress);

/// Throws Error (Usage) for invalid sections, keys and values, as generate_list() would before it
/// starts. Does not read maps.
void check_generation(const IniFile& ini, const GenerationOptions& options);

}  // namespace slalom
