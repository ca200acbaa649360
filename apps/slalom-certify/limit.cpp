// SPDX-License-Identifier: BSD-3-Clause
#include "certificate.h"
#include "verbs.h"

#include <slalom/app/campaign_names.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>

#include <iostream>

namespace slalom {
namespace {

struct LimitArguments {
  CampaignArguments campaign;
  LimitQuestion question;
  std::string of, output;
  std::optional<double> require;
};

bool is_in_range(const Bins& bins, double value) {
  return value >= std::min(bins.from, bins.to) && value <= std::max(bins.from, bins.to);
}

/// Whether the claim reaches the value.
bool covers(const Bins& bins, std::optional<double> limit, double value) {
  return limit && (bins.to > bins.from ? *limit >= value : *limit <= value);
}

void limit_verb(LimitArguments& arguments) {
  LimitQuestion& question = arguments.question;
  question.parameter = parse_parameter(arguments.of);
  IniFile ini = load_campaign_ini(arguments.campaign);
  if (!arguments.output.empty()) refuse_output_over_inputs(arguments.output, ini);
  if (arguments.require && !is_in_range(question.bins, *arguments.require))
    throw usage_error("--require " + format_number(*arguments.require),
                      "is not between --from and --to", "a value of " + question.parameter.name);
  const LimitJob job = make_limit_job(question, std::move(ini));
  const LimitAnswer answer = execute(job, arguments.campaign);
  if (!arguments.output.empty())
    write_file_atomically(arguments.output, certificate_text(job, answer));
  std::cout << limit_text(job, answer);
  const std::optional<double> limit = limit_of(job.question, answer.result);
  if (arguments.require && !covers(job.question.bins, limit, *arguments.require))
    throw job_error(
        "--require " + job.question.bins.value_text(*arguments.require),
        limit ? "the limit is " + job.question.bins.value_text(*limit) : "nothing can be claimed",
        "a claim up to that value");
}

/// The options of the search with their defaults.
void add_search_options(CLI::App& app, LimitOptions& search) {
  app.add_option("--reliability", search.reliability, "Rate of success to show")
      ->capture_default_str();
  app.add_option("--confidence", search.confidence,
                 "Confidence of the claim: 1 minus the probability that it is wrong")
      ->capture_default_str();
  app.add_option("--blocks", search.blocks,
                 "Blocks of bins before the limit of the pilot; 0: each bin is claimed by itself")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  app.add_option("--budget", search.budget, "Runs for the claim")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--max-per-step", search.max_per_step, "Runs for one block or bin of the claim")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

}  // namespace

void define_limit(CLI::App& app) {
  static LimitArguments arguments;
  CampaignArguments& campaign = arguments.campaign;
  Bins& bins = arguments.question.bins;
  CLI::App* verb = app.add_subcommand(
      "limit",
      "Find the hardest values of a parameter up to which the method succeeds with a reliability");
  add_argument(*verb, {"campaign", "-c,--config", "The campaign's .ini"}, campaign.config);
  complete_with(verb->add_option("--method", arguments.question.method, "The method that is tested")
                    ->required(),
                known_methods);
  complete_with(
      verb->add_option("--of", arguments.of,
                       "The parameter: FAMILY.OPTION of a generator, such as passage.width for "
                       "min_width and max_width; robot.KEY or sensor.KEY, in the scenarios of the "
                       "generators of the .ini")
          ->required(),
      [](const Words&) { return parameter_names(); });
  verb->add_option("--from", bins.from, "The easy end")->required();
  verb->add_option("--to", bins.to, "The hard end")->required();
  verb->add_option("--step", bins.step,
                   "Width of a bin, in which each run draws its value; of an integer, the values "
                   "in a bin, without that of --to")
      ->required();
  add_search_options(*verb, arguments.question.search);
  verb->add_option("-o,--output", arguments.output, "The certificate (.certificate.json) to write");
  verb->add_option("--require", arguments.require,
                   "Exit status 1 unless the claim reaches this value");
  verb->add_option("--seed", campaign.seed, "Seed instead of [campaign] seed");
  add_jobs_option(*verb, campaign.jobs, "Worker processes");
  complete_with(
      verb->add_option("--set", campaign.overrides, "Override a key of the .ini: SECTION.KEY=VALUE")
          ->take_all()
          ->allow_extra_args(false),
      setting_names);
  verb->add_flag("--quiet", campaign.quiet, "No progress and no messages, except errors");
  verb->callback([] { limit_verb(arguments); });
}

}  // namespace slalom
