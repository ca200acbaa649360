// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/result_file.h>

#include <string>

namespace slalom {

/// All data of a run as text: outcome, metrics and descriptors with versions, units and NA reasons,
/// wall-clock measurements.
std::string run_text(const ResultFile& file, const RunRecord& run);

}  // namespace slalom
