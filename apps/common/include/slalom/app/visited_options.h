// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/option.h>

#include <CLI/CLI.hpp>

#include <functional>

namespace slalom {

/// Adds an option to the app for each one that `visit` visits, with its help, range, choices and
/// default: "max_range" is --max-range. Values are set when the command line is parsed, for which
/// `visit` is called again: what it visits must outlive the app. Parsing throws Error (Usage), as
/// for an .ini, for a value that is not valid.
void add_visited_options(CLI::App& app, const std::function<void(OptionVisitor&)>& visit);

/// The same for the options of a struct, which must outlive the app.
template <typename Options>
void add_options_of(CLI::App& app, Options& options) {
  add_visited_options(app, [&options](OptionVisitor& v) { options.visit(v); });
}

}  // namespace slalom
