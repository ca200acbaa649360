#pragma once

#include <slalom/results/run_record.h>

#include <string>

namespace slalom {

/// The run that `id` names: its run id, as tables and dumps print it, or a unique beginning of the
/// full scenario hash with method and repetition. Throws Error (Usage) otherwise.
const RunRecord& find_run(const ResultTable& table, const std::string& id);

/// Everything known of a run, for people: outcome, metrics and descriptors with versions, units and
/// the reasons of missing values, wall-clock figures.
std::string run_text(const ResultTable& table, const RunRecord& run);

}  // namespace slalom
