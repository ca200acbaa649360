#include "verbs.h"

#include <slalom/app/adapters.h>
#include <slalom/app/campaign_program.h>
#include <slalom/campaign/campaign_options.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/rawlog/open_loop.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace slalom {
namespace {

using Json = nlohmann::json;

struct OpenLoopArguments {
  std::string log, method, label;
  CampaignArguments campaign;
  double goal_ahead = 5;
  bool each = false, json = false;
};

/// Counts over all scans of a log.
struct OpenLoopSummary {
  std::size_t scans = 0, with_odometry = 0, commands = 0, problems = 0, at_once = 0, stopping = 0,
              one_second = 0;
  double mean_v = 0, mean_unseen = 0;
};

OpenLoopSummary summarise(const std::vector<LoggedScan>& scans,
                          const std::vector<OpenLoopAnswer>& answers) {
  OpenLoopSummary sum;
  sum.scans = answers.size();
  for (const LoggedScan& scan : scans) sum.with_odometry += scan.odometry ? 1 : 0;
  for (const OpenLoopAnswer& answer : answers) {
    sum.mean_unseen += answer.unseen_rays;
    if (!answer.problem.empty()) continue;
    ++sum.commands;
    sum.mean_v += answer.command.v;
    sum.at_once += answer.forecast.at_once ? 1 : 0;
    sum.stopping += answer.forecast.stopping ? 1 : 0;
    sum.one_second += answer.forecast.one_second ? 1 : 0;
  }
  sum.problems = sum.scans - sum.commands;
  sum.mean_unseen /= static_cast<double>(std::max<std::size_t>(sum.scans, 1));
  sum.mean_v /= static_cast<double>(std::max<std::size_t>(sum.commands, 1));
  return sum;
}

Json to_json(const OpenLoopAnswer& answer) {
  Json json = {{"time", answer.time}, {"unseen_rays", answer.unseen_rays}};
  if (!answer.problem.empty()) {
    json["problem"] = answer.problem;
    return json;
  }
  json["v"] = answer.command.v;
  json["w"] = answer.command.w;
  json["vy"] = answer.command.vy;
  json["contact"] = {{"already", answer.forecast.at_once},
                     {"stopping", answer.forecast.stopping},
                     {"one_second", answer.forecast.one_second}};
  return json;
}

void print_json(const OpenLoopArguments& arguments, const OpenLoopSummary& sum,
                const std::vector<OpenLoopAnswer>& answers) {
  Json json = {
      {"log", arguments.log},
      {"method", arguments.method},
      {"goal_ahead", arguments.goal_ahead},
      {"scans", sum.scans},
      {"with_odometry", sum.with_odometry},
      {"commands", sum.commands},
      {"problems", sum.problems},
      {"mean_v", sum.mean_v},
      {"mean_unseen_rays", sum.mean_unseen},
      {"contact",
       {{"already", sum.at_once}, {"stopping", sum.stopping}, {"one_second", sum.one_second}}}};
  if (arguments.each)
    for (const OpenLoopAnswer& answer : answers) json["answers"].push_back(to_json(answer));
  std::cout << json.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
}

void print_each(const std::vector<OpenLoopAnswer>& answers) {
  std::cout << "time_s v w vy contact\n";
  for (const OpenLoopAnswer& answer : answers) {
    std::cout << format_fixed(answer.time, 3) << " ";
    if (!answer.problem.empty()) {
      std::cout << "- - - " << answer.problem << "\n";
      continue;
    }
    const Forecast& forecast = answer.forecast;
    std::cout << format_fixed(answer.command.v, 3) << " " << format_fixed(answer.command.w, 3)
              << " " << format_fixed(answer.command.vy, 3) << " "
              << (forecast.at_once      ? "already"
                  : forecast.stopping   ? "stopping"
                  : forecast.one_second ? "one_second"
                                        : "none")
              << "\n";
  }
  std::cout << "\n";
}

void print_summary(const OpenLoopArguments& arguments, const OpenLoopSummary& sum) {
  std::cout << arguments.log << ": " << arguments.method << ", goal "
            << format_number(arguments.goal_ahead) << " m ahead\n"
            << "scans                                 " << sum.scans << "\n"
            << "  with odometry                       " << sum.with_odometry << "\n"
            << "  rays that the log does not show     " << format_fixed(sum.mean_unseen, 1)
            << " on average\n"
            << "commands                              " << sum.commands << "\n"
            << "  mean speed ahead                    " << format_fixed(sum.mean_v, 3) << " m/s\n"
            << "  robot touches the scan already      " << sum.at_once << "\n"
            << "  contact, braking one period later   " << sum.stopping << "\n"
            << "  contact, held for one second        " << sum.one_second << "\n"
            << "scans without a command               " << sum.problems << "\n";
}

void tell_problem(const std::vector<OpenLoopAnswer>& answers, const std::string& log) {
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
  const auto method = all_adapters().create(
      arguments.method,
      {ini, "method." + arguments.method, options.setup.robot, options.setup.sensor});
  const auto scans = read_laser_log(arguments.log, arguments.label);
  const auto& simulation = options.setup.simulation;
  const auto answers =
      replay_open_loop(scans,
                       {options.setup.robot, options.setup.sensor, simulation.control_period,
                        simulation.goal_tolerance, arguments.goal_ahead},
                       *method);
  const OpenLoopSummary sum = summarise(scans, answers);
  if (arguments.json) {
    print_json(arguments, sum, answers);
  } else {
    if (arguments.each) print_each(answers);
    print_summary(arguments, sum);
  }
  tell_problem(answers, arguments.log);
}

}  // namespace

void define_openloop(CLI::App& app) {
  static OpenLoopArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "openloop", "Give every 2D scan of any rawlog to a method and look where its commands lead");
  verb->add_option("log", arguments.log, "A rawlog with CObservation2DRangeScan")->required();
  verb->add_option("--method", arguments.method, "A method of the campaign's .ini")->required();
  verb->add_option("-c,--config", arguments.campaign.config,
                   "The campaign's .ini: robot, sensor, methods")
      ->required();
  verb->add_option("--set", arguments.campaign.overrides,
                   "Override a key of the .ini: SECTION.KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  verb->add_option("--goal-ahead", arguments.goal_ahead, "Distance of the goal, straight ahead, m")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
  verb->add_option("--label", arguments.label, "Only scans of the sensor with this label");
  verb->add_flag("--each", arguments.each, "Also the answer to each scan");
  verb->add_flag("--json", arguments.json, "One JSON object");
  verb->callback([] { replay(arguments); });
}

}  // namespace slalom
