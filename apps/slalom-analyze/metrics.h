#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the verb that computes the metrics of a trajectory from any log.
void define_metrics(CLI::App& app);

}  // namespace slalom
