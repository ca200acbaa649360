// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/log_objects.h>

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds --scan, --odom, --command and --base.
void add_bag_options(CLI::App& verb, BagSelection& selection);

/// Prints what the import of a bag assumed, on standard error.
void print_notes(const LogObjects& log);

}  // namespace slalom
