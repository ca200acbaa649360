// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds a verb for each interpreter: `table`, `compare`, `map`, ...
void define_interpreters(CLI::App& app);

}  // namespace slalom
