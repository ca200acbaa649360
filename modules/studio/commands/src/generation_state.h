// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/scenario_sources.h>
#include <slalom/io/scenario_list.h>

#include <string>

namespace slalom {

// Progress of a generation, stored as a note of its list. Reading gives the beginning if there is
// no note, or if the generation ended, and throws Error (File) for a damaged one.

SourceState read_source_state(const ScenarioList& list);
void store_source_state(ScenarioList& list, const SourceState& state);

/// Evaluations of a coverage generation, see CoverageSettings::known.
std::string read_evaluations(const ScenarioList& list);
void store_evaluations(ScenarioList& list, const std::string& evaluations);

bool is_begun(const ScenarioList& list);  ///< whether anything was stored
void store_end_of_generation(ScenarioList& list);

}  // namespace slalom
