// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Checks of the values of options; their errors read as those of an .ini.
CLI::Validator above_zero();
CLI::Validator not_negative();
CLI::Validator in_range(double low, double high);  ///< both included

/// Checks that the values of all options that are numbers are finite ones.
void check_numbers(CLI::App& app);

}  // namespace slalom
