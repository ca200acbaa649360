// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

// Each adds verbs with their options and callbacks.
void define_questions(CLI::App& app);
void define_show(CLI::App& app);
void define_verify(CLI::App& app);

}  // namespace slalom
