// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/campaign_names.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/ros_parameters/resolve.h>

#include <iostream>

namespace slalom {
namespace {

struct ParametersArguments {
  std::string config;
  std::vector<std::string> overrides;
  bool diff = false;
};

void print_parameters(const ParametersArguments& arguments) {
  IniFile ini = IniFile::load(arguments.config);
  for (const std::string& assignment : arguments.overrides) ini.override_key(assignment);
  const std::vector<RosParameterReport> reports = resolve_ros_parameters(ini);
  if (reports.empty())
    throw usage_error(arguments.config, "no section has the key from",
                      "from = FILE in [robot], [sensor] or [method.NAME]");
  if (!arguments.diff) {
    for (const RosParameterReport& report : reports) std::cout << report.listing();
    return;
  }
  std::cout << ros_parameter_diff(reports);
  for (const RosParameterReport& report : reports)
    for (const std::string& parameter : report.not_in_file)
      print_notice("not in " + report.source + ": " + parameter);
}

}  // namespace

void define_parameters(CLI::App& app) {
  static ParametersArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "parameters",
      "Print what becomes of the parameters of Nav2 or move_base that a campaign's .ini names");
  add_argument(*verb, {"campaign", "-c,--config", "The campaign's .ini"}, arguments.config);
  CLI::Option* set = verb->add_option("--set", arguments.overrides,
                                      "Override a key of the .ini: SECTION.KEY=VALUE")
                         ->take_all()
                         ->allow_extra_args(false);
  complete_with(set, setting_names);
  verb->add_flag("--diff", arguments.diff,
                 "A diff that writes the values of the .ini into the files, for patch");
  verb->callback([] { print_parameters(arguments); });
}

}  // namespace slalom
