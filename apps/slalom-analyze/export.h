// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the verb `export`.
void define_export(CLI::App& app);

}  // namespace slalom
