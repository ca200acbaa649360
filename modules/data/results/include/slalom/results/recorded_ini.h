// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/results/run_record.h>

#include <string>

namespace slalom {

/// The .ini of the campaign in a manifest; an empty one where it has none. `origin` is its name in
/// errors. Throws Error (Usage) on a malformed line.
IniFile recorded_ini(const Manifest& manifest, const std::string& origin);

}  // namespace slalom
