// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

// Each adds a verb.
void define_bundle(CLI::App& app);  ///< and unpack
void define_merge(CLI::App& app);
void define_parameters(CLI::App& app);
void define_slurm(CLI::App& app);
void define_status(CLI::App& app);
void define_verify(CLI::App& app);

}  // namespace slalom
