// SPDX-License-Identifier: BSD-3-Clause
#include "generate.h"

#include <slalom/app/checks.h>
#include <slalom/app/completion.h>
#include <slalom/app/existing_options.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/commands/describe_list.h>
#include <slalom/commands/generation_file.h>
#include <slalom/core/available_cores.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/generation/generator.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/robot/robot_model.h>
#include <slalom/ros_parameters/resolve.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <optional>

namespace slalom {
namespace {

using Json = nlohmann::ordered_json;

struct GenerateArguments {
  std::string config, family, output, descriptors;
  std::vector<std::string> overrides;
  int count = 0, jobs = 1;
  std::optional<std::uint64_t> seed;  ///< default: that of [campaign]
  ExistingResults existing = ExistingResults::Continue;
  bool take_over = false;
  bool quiet = false, json = false;
};

IniFile load_ini(const GenerateArguments& arguments) {
  if (arguments.config.empty() && arguments.family.empty())
    throw usage_error("generate", "no scenarios described", "--family NAME or --config FILE.ini");
  IniFile ini = arguments.config.empty() ? IniFile::from_text("") : IniFile::load(arguments.config);
  if (!arguments.family.empty()) ini.set("scenarios", "generator", arguments.family);
  for (const std::string& assignment : arguments.overrides) ini.override_key(assignment);
  ini.reject_unknown_sections(campaign_sections({"coverage"}));
  if (arguments.count > 0) {
    const bool fills_bins = ini.has_section("coverage");
    ini.set(fills_bins ? "coverage" : "scenarios", fills_bins ? "per_bin" : "count",
            std::to_string(arguments.count));
  }
  for (const RosParameterReport& report : resolve_ros_parameters(ini))
    if (!arguments.quiet) std::cerr << report.summary() << "\n";
  const std::string warning = sensor_warning(ini);
  if (!warning.empty() && !arguments.quiet) std::cerr << "warning: " << warning << "\n";
  return ini;
}

Json to_json(const GeneratedBins& generated) {
  Json bins = Json::array();
  for (const BinReport& bin : generated.result.bins) {
    Json json;
    for (std::size_t i = 0; i < generated.plan.axes.size(); ++i)
      json[generated.plan.axes[i].id] = {bin.intervals[i].first, bin.intervals[i].second};
    json["wanted"] = bin.wanted;
    json["found"] = bin.found;
    json["effort"] = bin.effort;
    json["verdict"] = to_string(bin.verdict);
    if (!bin.reason.empty()) json["reason"] = bin.reason;
    bins.push_back(json);
  }
  return {{"bins", bins},
          {"scenarios", generated.result.scenarios.size()},
          {"evaluations", generated.result.evaluations},
          {"stopped", generated.result.stopped},
          {"repeatable", generated.result.repeatable}};
}

/// The seed of [campaign], which is that of all programs.
struct CampaignSeed {
  std::uint64_t seed = 1;
  void visit(OptionVisitor& v) { v.option("seed", seed, "seed of all random numbers"); }
};

std::uint64_t seed_of(const IniFile& ini, const GenerateArguments& arguments) {
  CampaignSeed campaign;
  OptionReader reader(ini, "campaign");
  campaign.visit(reader);
  return arguments.seed.value_or(campaign.seed);
}

void print_bins(const GeneratedBins& generated, const GenerateArguments& arguments) {
  if (arguments.json)
    std::cout << to_json(generated).dump() << "\n";
  else if (!arguments.quiet)
    std::cout << render_coverage(generated.plan, generated.result);
}

void generate(const GenerateArguments& arguments) {
  const IniFile ini = load_ini(arguments);
  refuse_output_over_inputs(arguments.output, ini);
  if (ini.has_section("coverage") && !arguments.descriptors.empty())
    throw usage_error("--describe", "cannot be combined with [coverage]",
                      "descriptors in that section");
  const GenerationOptions order = {seed_of(ini, arguments), worker_count(arguments.jobs),
                                   split(arguments.descriptors, ',')};
  const auto progress = make_interruptible_progress(arguments.quiet);
  const auto notify = [&](const std::string& line) {
    if (!arguments.quiet) std::cerr << line << std::endl;
  };
  const GenerationFile file = {arguments.output, arguments.existing, arguments.take_over, notify};
  const auto bins = generate_file(file, ini, order, load_occupancy_grid, *progress);
  if (bins) print_bins(*bins, arguments);
  notify(arguments.output + ": " +
         count_text(ScenarioList::open(arguments.output).size(), "scenario"));
}

/// The candidates for --set.
Words generator_settings(const Words& words) {
  SettingNames names;
  names.add_names("scenarios.generator", generator_names());
  for (const std::string& family : generator_names())
    visit_generator_options(family, *names.collector("generator." + family));
  return names.matching(words.back());
}

}  // namespace

void add_generate_verb(CLI::App& app) {
  static GenerateArguments arguments;
  CLI::App* verb = app.add_subcommand("generate", "Generate solvable scenarios");
  verb->add_option("-c,--config", arguments.config,
                   "An .ini with [scenarios] generator = NAME[, NAME...]");
  complete_with(verb->add_option("--family", arguments.family,
                                 "Families, comma-separated, overrides [scenarios] generator"),
                [](const Words&) { return generator_names(); });
  verb->add_option("-n,--count", arguments.count,
                   "Number of scenarios, overrides [scenarios] count; or per bin, overrides "
                   "[coverage] per_bin")
      ->check(above_zero());
  verb->add_option("--seed", arguments.seed, "Seed instead of [campaign] seed (default: 1)");
  add_jobs_option(*verb, arguments.jobs, "Threads; the list does not depend on their number");
  complete_with(verb->add_option("--describe", arguments.descriptors,
                                 "Descriptors to compute and store, comma-separated"),
                [](const Words&) { return descriptor_ids(); });
  verb->add_option("-o,--output", arguments.output, "The list to write (.scenarios)")->required();
  complete_with(verb->add_option("--set", arguments.overrides,
                                 "Override a key of the .ini: SECTION.KEY=VALUE")
                    ->allow_extra_args(false),
                generator_settings);
  add_existing_options(*verb, arguments.existing, arguments.take_over);
  verb->add_flag("--json", arguments.json, "Print the table of [coverage] as a JSON object");
  verb->add_flag("--quiet", arguments.quiet, "No progress and no messages");
  verb->callback([] { generate(arguments); });
}

}  // namespace slalom
