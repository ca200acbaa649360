// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace slalom {

void add_import_verb(CLI::App& app);

/// Writes a new list of these scenarios, with notes (key, text) about their origin.
void write_scenarios(const std::string& path, std::vector<Scenario> scenarios,
                     const std::vector<std::pair<std::string, std::string>>& notes, bool quiet);

}  // namespace slalom
