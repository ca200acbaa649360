// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds --resume, --overwrite and --take-over of programs that continue an output. `Existing` is an
/// enum with Require and Overwrite. Both values must outlive the app.
template <typename Existing>
void add_existing_options(CLI::App& app, Existing& existing, bool& take_over) {
  const auto choose = [&existing](Existing choice) {
    return [&existing, choice] { existing = choice; };
  };
  CLI::Option* resume =
      app.add_flag_callback("--resume", choose(Existing::Require),
                            "Fail unless there are results to continue. Without it they are "
                            "continued if they exist");
  app.add_flag_callback("--overwrite", choose(Existing::Overwrite),
                        "Start over: replace the results of this or another command")
      ->excludes(resume);
  app.add_flag("--take-over", take_over,
               "Take the lock of a program on another host, which must have ended");
}

}  // namespace slalom
