// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/rawlog/open_loop_summary.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using Json = nlohmann::json;

Json to_json(const OpenLoopAnswer& answer) {
  Json json = {{"time", answer.time}, {"uncovered_rays", answer.uncovered_rays}};
  if (!answer.problem.empty()) {
    json["problem"] = answer.problem;
    return json;
  }
  json["v"] = answer.command.v;
  json["w"] = answer.command.w;
  json["vy"] = answer.command.vy;
  json["contact"] = {{"already", answer.prediction.in_contact},
                     {"stopping", answer.prediction.stopping},
                     {"one_second", answer.prediction.one_second}};
  return json;
}

std::string contact_text(const ContactPrediction& prediction) {
  return prediction.in_contact   ? "already"
         : prediction.stopping   ? "stopping"
         : prediction.one_second ? "one_second"
                                 : "none";
}

}  // namespace

OpenLoopSummary summarize(const std::vector<LoggedScan>& scans,
                          const std::vector<OpenLoopAnswer>& answers) {
  OpenLoopSummary sum;
  sum.scans = answers.size();
  for (const LoggedScan& scan : scans) sum.with_odometry += scan.odometry ? 1 : 0;
  for (const OpenLoopAnswer& answer : answers) {
    sum.mean_uncovered += answer.uncovered_rays;
    if (!answer.problem.empty()) continue;
    ++sum.commands;
    sum.mean_v += answer.command.v;
    sum.in_contact += answer.prediction.in_contact ? 1 : 0;
    sum.stopping += answer.prediction.stopping ? 1 : 0;
    sum.one_second += answer.prediction.one_second ? 1 : 0;
  }
  for (std::size_t i = 0; i + 1 < std::min(scans.size(), answers.size()); ++i) {
    const auto& next = scans[i + 1].velocity;
    if (!answers[i].problem.empty() || !next) continue;
    ++sum.compared;
    sum.difference_v += std::abs(answers[i].command.v - next->vx);
    sum.difference_w += std::abs(answers[i].command.w - next->omega);
  }
  const auto compared = static_cast<double>(std::max<std::size_t>(sum.compared, 1));
  sum.difference_v /= compared;
  sum.difference_w /= compared;
  sum.problems = sum.scans - sum.commands;
  sum.mean_uncovered /= static_cast<double>(std::max<std::size_t>(sum.scans, 1));
  sum.mean_v /= static_cast<double>(std::max<std::size_t>(sum.commands, 1));
  return sum;
}

std::string render_text(const OpenLoopSummary& sum) {
  const auto line = [](const std::string& name, const std::string& value) {
    return name + std::string(38 - name.size(), ' ') + value + "\n";
  };
  const auto count = [&](const std::string& name, std::size_t n) {
    return line(name, std::to_string(n));
  };
  return sum.log + ": " + sum.method + ", goal " + format_number(sum.goal_ahead) + " m ahead\n" +
         count("scans", sum.scans) + count("  with odometry", sum.with_odometry) +
         line("  rays not covered by the log",
              format_fixed(sum.mean_uncovered, 1) + " on average") +
         count("commands", sum.commands) +
         line("  mean linear velocity", format_fixed(sum.mean_v, 3) + " m/s") +
         line("  distance from the log's velocity",
              sum.compared == 0 ? "NA: no command before a scan with a velocity"
                                : format_fixed(sum.difference_v, 3) + " m/s, " +
                                      format_fixed(sum.difference_w, 3) + " rad/s on average") +
         count("  robot already in contact", sum.in_contact) +
         count("  contact, braking after one period", sum.stopping) +
         count("  contact, held for one second", sum.one_second) +
         count("scans without a command", sum.problems);
}

std::string render_text(const std::vector<OpenLoopAnswer>& answers) {
  std::string text = "time_s v w vy contact\n";
  for (const OpenLoopAnswer& answer : answers) {
    text += format_fixed(answer.time, 3) + " ";
    if (!answer.problem.empty()) {
      text += "- - - " + answer.problem + "\n";
      continue;
    }
    const Command& command = answer.command;
    text += join({format_fixed(command.v, 3), format_fixed(command.w, 3),
                  format_fixed(command.vy, 3), contact_text(answer.prediction)},
                 " ") +
            "\n";
  }
  return text + "\n";
}

std::string render_json(const OpenLoopSummary& sum, const std::vector<OpenLoopAnswer>& answers) {
  Json json = {
      {"log", sum.log},
      {"method", sum.method},
      {"goal_ahead", sum.goal_ahead},
      {"scans", sum.scans},
      {"with_odometry", sum.with_odometry},
      {"commands", sum.commands},
      {"problems", sum.problems},
      {"mean_v", sum.mean_v},
      {"mean_uncovered_rays", sum.mean_uncovered},
      {"log_velocities",
       {{"compared", sum.compared},
        {"difference_v", sum.compared == 0 ? Json() : Json(sum.difference_v)},
        {"difference_w", sum.compared == 0 ? Json() : Json(sum.difference_w)}}},
      {"contact",
       {{"already", sum.in_contact}, {"stopping", sum.stopping}, {"one_second", sum.one_second}}}};
  for (const OpenLoopAnswer& answer : answers) json["answers"].push_back(to_json(answer));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace slalom
