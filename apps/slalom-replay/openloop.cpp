// SPDX-License-Identifier: BSD-3-Clause
#include "bag_options.h"
#include "verbs.h"

#include <slalom/app/adapters.h>
#include <slalom/app/campaign_names.h>
#include <slalom/app/campaign_program.h>
#include <slalom/app/checks.h>
#include <slalom/campaign/campaign_options.h>
#include <slalom/core/error.h>
#include <slalom/io/result_file.h>
#include <slalom/rawlog/open_loop_picture.h>
#include <slalom/rawlog/open_loop_summary.h>

#include <algorithm>
#include <iostream>

namespace slalom {
namespace {

struct OpenLoopArguments {
  std::string log, method, label, picture;
  CampaignArguments campaign;
  BagSelection selection;
  double goal_ahead = 5;
  bool each = false, json = false;
};

void report_problem(const std::vector<OpenLoopAnswer>& answers, const std::string& log) {
  const auto first = std::find_if(answers.begin(), answers.end(), [](const OpenLoopAnswer& answer) {
    return !answer.problem.empty();
  });
  if (first != answers.end())
    throw job_error(log, "scan " + std::to_string(first - answers.begin() + 1) +
                             " has no command: " + first->problem);
}

void replay(const OpenLoopArguments& arguments) {
  const IniFile ini = load_campaign_ini(arguments.campaign);
  const CampaignOptions options = read_campaign_options(ini);
  const auto method =
      all_adapters().read(ini, arguments.method).make(options.robot, options.sensor);
  method->check();
  const LogObjects log = load_log(arguments.log, arguments.selection);
  print_notes(log);
  const auto scans = read_laser_log(log, arguments.label);
  const auto& simulation = options.simulation;
  const auto answers = replay_open_loop(scans,
                                        {options.robot, options.sensor, simulation.control_period,
                                         simulation.goal_tolerance, arguments.goal_ahead},
                                        *method);
  OpenLoopSummary sum = summarize(scans, answers);
  if (!arguments.picture.empty()) {
    LogMapOptions map;
    map.robot_radius = options.robot.radius;
    write_file_atomically(arguments.picture,
                          open_loop_picture(map_of_scans(log, arguments.log, map), scans, answers,
                                            options.robot.radius) +
                              "\n");
  }
  sum.log = arguments.log;
  sum.method = arguments.method;
  sum.goal_ahead = arguments.goal_ahead;
  const auto each = arguments.each ? answers : std::vector<OpenLoopAnswer>();
  if (arguments.json)
    std::cout << render_json(sum, each) << "\n";
  else
    std::cout << (arguments.each ? render_text(each) : "") << render_text(sum);
  report_problem(answers, arguments.log);
}

}  // namespace

void define_openloop(CLI::App& app) {
  static OpenLoopArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "openloop", "Pass each 2D scan of any rawlog or bag to a method and predict contacts");
  verb->add_option("log", arguments.log, "Rawlog with CObservation2DRangeScan, or bag of ROS")
      ->required();
  complete_with(
      verb->add_option("--method", arguments.method, "Method of the campaign .ini")->required(),
      known_methods);
  verb->add_option("-c,--config", arguments.campaign.config,
                   "Campaign .ini: robot, sensor, methods")
      ->required();
  verb->add_option("--set", arguments.campaign.overrides,
                   "Override a key of the .ini: SECTION.KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  verb->add_option("--goal-ahead", arguments.goal_ahead, "Distance of the goal straight ahead, m")
      ->check(in_range(0.1, 1000.0))
      ->capture_default_str();
  verb->add_option("--label", arguments.label, "Use only scans of the sensor with this label");
  add_bag_options(*verb, arguments.selection);
  verb->add_option(
      "--picture", arguments.picture,
      "SVG of the drive, with the commands and where they would have ended in contact");
  verb->add_flag("--each", arguments.each, "Also print the answer to each scan");
  verb->add_flag("--json", arguments.json, "Print one JSON object");
  verb->callback([] { replay(arguments); });
}

}  // namespace slalom
