// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

void define_registry(CLI::App& app);

}  // namespace slalom
