// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the verb `sim2real`.
void define_sim2real(CLI::App& app);

}  // namespace slalom
