// SPDX-License-Identifier: BSD-3-Clause
#include "bag_options.h"
#include "verbs.h"

#include <slalom/app/campaign_program.h>
#include <slalom/app/checks.h>
#include <slalom/core/error.h>
#include <slalom/rawlog/identification.h>

#include <algorithm>
#include <iostream>

namespace slalom {
namespace {

struct IdentifyArguments {
  std::string log;
  CampaignArguments campaign;
  MotionLabels labels;
  BagSelection selection;
  double max_delay = IdentificationSetup().max_delay;
  bool json = false;
};

std::string reasons(const Identification& identification) {
  std::string text;
  for (const char* id : {"delay", "noise_sigma"})
    text +=
        std::string(text.empty() ? "" : "; ") + id + ": " + identification.at(id).value.reason();
  return text;
}

void identify_robot(const IdentifyArguments& arguments) {
  IdentificationSetup setup;
  setup.max_delay = arguments.max_delay;
  if (!arguments.campaign.config.empty())
    setup.robot = read_robot_model(load_campaign_ini(arguments.campaign));
  const LogObjects log = load_log(arguments.log, arguments.selection);
  print_notes(log);
  Identification identification = identify(read_motion_log(log, arguments.labels), setup);
  const auto& estimates = identification.estimates;
  if (std::all_of(estimates.begin(), estimates.end(),
                  [](const Estimate& estimate) { return estimate.value.is_na(); }))
    throw file_error(arguments.log, "nothing can be estimated (" + reasons(identification) + ")",
                     "commanded and measured velocities, or scans of a stationary robot");
  identification.log = arguments.log;
  std::cout << (arguments.json ? render_json(identification) + "\n" : render_text(identification));
}

}  // namespace

void define_identify(CLI::App& app) {
  static IdentifyArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "identify",
      "Estimate delay, lag, speed bias and range noise of the robot of a rawlog or bag");
  verb->add_option("log", arguments.log,
                   "Rawlog with velocities as CObservationOdometry, or bag of ROS")
      ->required();
  CLI::Option* config = verb->add_option("-c,--config", arguments.campaign.config,
                                         "Campaign .ini with the robot's limits");
  verb->add_option("--set", arguments.campaign.overrides,
                   "Override a key of the .ini: SECTION.KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false)
      ->needs(config);
  verb->add_option("--command-label", arguments.labels.command, "Label of commanded velocities")
      ->capture_default_str();
  verb->add_option("--odometry-label", arguments.labels.odometry, "Label of measured velocities")
      ->capture_default_str();
  verb->add_option("--label", arguments.labels.scan,
                   "Use only scans of the sensor with this label");
  add_bag_options(*verb, arguments.selection);
  verb->add_option("--max-delay", arguments.max_delay, "Maximum delay of commands, s")
      ->check(in_range(0.01, 10.0))
      ->capture_default_str();
  verb->add_flag("--json", arguments.json, "Print one JSON object");
  verb->callback([] { identify_robot(arguments); });
}

}  // namespace slalom
