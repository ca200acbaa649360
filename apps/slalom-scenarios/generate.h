// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

void add_generate_verb(CLI::App& app);

}  // namespace slalom
