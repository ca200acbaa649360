// SPDX-License-Identifier: BSD-3-Clause
#include "key_options.h"
#include "sim2real.h"
#include "warnings.h"

#include <slalom/analysis/sim2real.h>
#include <slalom/app/campaign_names.h>
#include <slalom/app/checks.h>
#include <slalom/app/completion.h>
#include <slalom/metrics/metric.h>
#include <slalom/tables/analysis_input.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <optional>
#include <string>

namespace slalom {
namespace {

struct Sim2RealArguments {
  std::string real, simulated, metric = "success";
  double confidence = 0.95, power = 0.8;
  CsvColumnOptions table;
  bool json = false;
};

void compare(const Sim2RealArguments& arguments) {
  AnalysisOptions options;
  options.confidence = arguments.confidence;
  const ResultTable real = read_analysis_input(arguments.real, std::nullopt, true, arguments.table);
  warn_of_missing(arguments.real, real);
  const ResultTable simulated = read_analysis_input(arguments.simulated, std::nullopt, false, {});
  warn_of_missing(arguments.simulated, simulated);
  const Sim2Real comparison = sim2real(real, simulated, arguments.metric, options, arguments.power);
  if (arguments.json)
    std::cout << sim2real_json(comparison).dump() << "\n";
  else
    std::cout << render_text(comparison);
}

}  // namespace

void define_sim2real(CLI::App& app) {
  static Sim2RealArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "sim2real", "Whether the order of methods in simulation is that in trials of a real robot");
  verb->add_option(
          "real", arguments.real,
          "Real trials, a table (.csv): columns method, scenario (may be left out) and the "
          "metric, a line per trial")
      ->required();
  verb->add_option("simulated", arguments.simulated, "A result file (.results)")->required();
  complete_with(verb->add_option("--metric", arguments.metric, "Metric that orders the methods")
                    ->capture_default_str(),
                [](const Words&) { return metric_ids(); });
  add_key_options(*verb, arguments.table, false);
  verb->add_option("--confidence", arguments.confidence, "Confidence of intervals and tests")
      ->check(in_range(0.5, 0.9999))
      ->capture_default_str();
  verb->add_option("--power", arguments.power, "Statistical power for the seen differences")
      ->check(in_range(0.5, 0.9999))
      ->capture_default_str();
  verb->add_flag("--json", arguments.json, "Print one JSON object");
  verb->callback([] { compare(arguments); });
}

}  // namespace slalom
