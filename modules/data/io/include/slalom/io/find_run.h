// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/result_file.h>

#include <string>

namespace slalom {

/// The run with this id as in tables and dumps, or with a unique prefix of the full scenario hash,
/// method and repetition. Throws Error (Usage) otherwise.
RunRecord find_run(const ResultFile& file, const std::string& id);

}  // namespace slalom
