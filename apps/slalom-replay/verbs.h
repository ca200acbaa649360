// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Each adds one verb with its options and callback to the program.
void define_play(CLI::App& app);
void define_check(CLI::App& app);
void define_metrics(CLI::App& app);
void define_openloop(CLI::App& app);
void define_identify(CLI::App& app);
void define_info(CLI::App& app);
void define_import(CLI::App& app);

}  // namespace slalom
