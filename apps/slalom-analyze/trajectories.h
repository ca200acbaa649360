// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the verb `trajectories`.
void define_trajectories(CLI::App& app);

}  // namespace slalom
