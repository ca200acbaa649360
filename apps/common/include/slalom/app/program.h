// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>
#include <slalom/core/ini_file.h>

#include <CLI/CLI.hpp>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace slalom {

/// Thrown by a verb that was interrupted by a signal, after saving its results: exit status 130.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An argument that is given by its position or by an option.
struct Argument {
  std::string position, option;  ///< e.g. "config", "-c,--config"
  std::string help;
  bool required = true;
};

/// Adds an argument. Giving it twice with different values is a usage error. At most one required
/// argument per app. `value` must outlive the app.
void add_argument(CLI::App& app, const Argument& argument, std::string& value);

/// Adds -j/--jobs; 0 is for all cores, see worker_count(). `jobs` must outlive the app.
CLI::Option* add_jobs_option(CLI::App& app, int& jobs, const std::string& help);

/// Adds an option whose values are the names of an enum. `value` must outlive the app.
template <typename Enum>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Enum& value,
                        const std::string& help) {
  const auto set = [&value](const std::string& text) { value = from_name<Enum>(text).value(); };
  return app.add_option_function<std::string>(name, set, help)
      ->check(CLI::IsMember(names_of<Enum>()));
}

/// Throws Error (Usage) if `output` is the .ini or a file that a value in it names: it would be
/// replaced.
void refuse_output_over_inputs(const std::string& output, const IniFile& ini);

/// The sections of an .ini of a campaign, for reject_unknown_sections(), and `more` of a program.
/// That of slalom-tune is among them: the other programs read what it writes.
std::vector<std::string> campaign_sections(std::vector<std::string> more = {});

/// Prints a line on standard error, for callbacks that notify of something.
void print_notice(const std::string& line);

/// Warns on standard error of what was damaged in a file and therefore skipped.
void warn_of_damage(const std::string& path, const std::vector<std::string>& damaged);

/// Runs a program of the form `PROGRAM VERB [OPTIONS] FILES` (or without verbs). `define` adds
/// verbs, options and callbacks to the app; the callbacks do the work and throw on failure. Adds
/// --help and --version. Returns the exit status: 0 for success; 1, 2 or 3 according to the Error,
/// or 1 for any other exception; 2 for an invalid command line; 130 for Interrupted. Messages are
/// one line on standard error, "PROGRAM: WHERE: WHAT; expected ..."; for an invalid command line
/// with a reference to --help. Without arguments it prints the help on standard error and returns
/// 2, unless `needs_arguments` is false.
int run_program(const std::string& name, const std::string& description, int argc, char** argv,
                const std::function<void(CLI::App&)>& define, bool needs_arguments = true);

}  // namespace slalom
