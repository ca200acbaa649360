// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/adapters.h>
#include <slalom/app/campaign_names.h>
#include <slalom/app/external_options.h>
#include <slalom/app/recorded_campaign.h>
#include <slalom/core/error.h>
#include <slalom/methods/registry.h>
#include <slalom/rawlog/re_execution.h>

#include <iostream>

namespace slalom {
namespace {

struct CheckArguments {
  std::string log, config, method;
  std::vector<std::string> overrides;
  bool trust = false;
};

void require_same_rays(const RecordedRun& run, const SensorModel& sensor, const IniFile& ini) {
  if (run.cycles.empty()) return;
  const std::size_t rays = run.cycles.front().scan->getScanSize();
  if (static_cast<std::size_t>(sensor.rays) != rays)
    throw usage_error(ini.where("sensor", "rays"),
                      std::to_string(sensor.rays) + " rays do not match the recorded scans",
                      std::to_string(rays));
}

void check(const CheckArguments& arguments) {
  const RecordedRun run = read_run(arguments.log);
  const IniFile ini = campaign_of(run, arguments.log, arguments.config, arguments.overrides);
  const CampaignOptions options = read_campaign_options(ini);
  require_same_rays(run, options.sensor, ini);
  const std::string name = arguments.method.empty() ? run.manifest.method : arguments.method;
  if (arguments.config.empty() && !arguments.trust)
    require_no_foreign_code(ini, method_sections(ini, name), arguments.log);
  const auto method = all_adapters().read(ini, name).make(options.robot, options.sensor);
  method->check();
  const auto found = first_difference(run, *method);
  if (found) throw job_error(arguments.log, *found, "the recorded command");
  std::cout << arguments.log << ": " << name << " reproduces all " << run.cycles.size()
            << " commands\n";
}

}  // namespace

void define_check(CLI::App& app) {
  static CheckArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "check", "Re-execute the method of a recorded run and compare its commands bitwise");
  verb->add_option("log", arguments.log, "The run (.rawlog)")->required();
  verb->add_option("-c,--config", arguments.config,
                   "Campaign .ini to use instead of the recorded one");
  verb->add_flag("--trust", arguments.trust,
                 "Execute the library, module or command that the recorded run names");
  complete_with(verb->add_option("--method", arguments.method, "Use another method of the .ini"),
                known_methods);
  verb->add_option("--set", arguments.overrides, "Override a key of the .ini: SECTION.KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  verb->callback([] { check(arguments); });
}

}  // namespace slalom
