// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the verb `metrics`.
void define_metrics(CLI::App& app);

}  // namespace slalom
