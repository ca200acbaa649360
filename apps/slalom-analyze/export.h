#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the verb that writes results for other programs.
void define_export(CLI::App& app);

}  // namespace slalom
