// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Verb import.
void define_import(CLI::App& app);

}  // namespace slalom
