// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the verb `figure`.
void define_figure(CLI::App& app);

}  // namespace slalom
