// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

// Each adds one verb with its options and callback.
void define_limit(CLI::App& app);
void define_verify(CLI::App& app);

}  // namespace slalom
