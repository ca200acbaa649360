#pragma once

#include <slalom/io/result_file.h>

#include <string>

namespace slalom {

/// The run with this id as in tables and dumps, or with a unique prefix of the full scenario hash,
/// method and repetition. Throws Error (Usage) otherwise.
RunRecord find_run(const ResultFile& file, const std::string& id);

/// All data of a run as text: outcome, metrics and descriptors with versions, units and NA reasons,
/// wall-clock measurements.
std::string run_text(const ResultFile& file, const RunRecord& run);

}  // namespace slalom
