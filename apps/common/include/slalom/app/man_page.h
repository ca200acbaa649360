// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace slalom {

/// The manual page of a program in the macros of man(7), with the texts of --help of the program
/// and of all its verbs. `version` is shown at the bottom, e.g. "Slalom 0.1.0".
std::string man_page(const CLI::App& app, const std::string& version);

}  // namespace slalom
