#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <stdexcept>
#include <string>

namespace slalom {

/// Thrown by a verb that a signal ended early, after what it had was kept: exit status 130.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a program of the form `PROGRAM VERB [OPTIONS] FILES` (or without verbs). `define` adds
/// verbs, options and callbacks to the app; the callbacks do the work and throw when they fail.
/// Adds --help and --version. Returns the exit status: 0 done; 1, 2 or 3 as the Error says, or 1
/// for any other exception; 2 for a wrong command line; 130 for Interrupted. Messages are one line
/// on standard error, "PROGRAM: WHERE: WHAT; expected ..."; for a wrong command line it also says
/// where help is. Without arguments it prints the help on standard error and returns 2, unless
/// `needs_arguments` is false.
int run_program(const std::string& name, const std::string& description, int argc, char** argv,
                const std::function<void(CLI::App&)>& define, bool needs_arguments = true);

}  // namespace slalom
