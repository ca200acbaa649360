// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

// Each adds one verb with its options and callback.
void define_search(CLI::App& app);
void define_shrink(CLI::App& app);

}  // namespace slalom
