// SPDX-License-Identifier: BSD-3-Clause
#include "failure_campaign.h"
#include "verbs.h"

#include <slalom/app/campaign_names.h>
#include <slalom/app/checks.h>
#include <slalom/app/existing_options.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/progress.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/core/wall_clock.h>
#include <slalom/falsification/search_summary.h>
#include <slalom/io/file_lock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace slalom {
namespace {

struct SearchArguments {
  FalsifyArguments common;
  std::string against;  ///< a library of the method's earlier version, or a method
  SearchOptions search;
  bool all_outcomes = false;
  std::optional<std::size_t> runs;
};

constexpr char kReference[] = "reference";
constexpr std::size_t kDefaultRuns = 10000;

/// Adds the earlier version of a compiled method as method "reference"; returns the witness's name.
std::string add_reference(IniFile& ini, const SearchArguments& arguments) {
  if (!ends_with(arguments.against, ".so")) return arguments.against;
  const std::string tested = "method." + arguments.common.method;
  const std::string section = std::string("method.") + kReference;
  for (const std::string& key : ini.keys(tested))
    ini.set(section, key, ini.get(tested, key).value_or(""));
  ini.set(section, "adapter", "library");
  ini.set(section, "plugin", std::filesystem::absolute(arguments.against).string());
  return kReference;
}

/// Hash of the settings, and of the methods with the contents of their files.
std::string hash_of_methods(const FalsifyCampaign& campaign) {
  Hasher hasher;
  for (const CampaignConfig* config : {&campaign.config, &campaign.surrogate}) {
    hasher.add(config->effective_ini);
    for (const auto* files : {&config->method_files, &config->dependencies})
      for (const auto& [key, path] : *files)
        hasher.add(key).add(read_file(path, "a file of a method"));
  }
  return hasher.hex();
}

/// Shows how many runs were made, or with a budget of time how many seconds passed, and how many
/// failures were found.
class SearchProgress {
 public:
  SearchProgress(const SearchOptions& options, bool quiet)
      : in_time_(options.runs == 0),
        total_(in_time_ ? static_cast<std::size_t>(std::ceil(60 * options.minutes)) : options.runs),
        began_(steady_seconds()),
        progress_(make_terminal_progress(quiet)) {
    show(options.known);
  }
  void show(const SearchState& state) {
    const std::size_t found = state.random.failures + state.adaptive.failures;
    if (found != found_)
      progress_->start("Searching, " + std::to_string(found) + " failures", total_);
    found_ = found;
    advance(state.runs());
  }
  void advance(std::size_t runs) {
    const auto seconds = static_cast<std::size_t>(steady_seconds() - began_);
    progress_->advance(std::min(in_time_ ? seconds : runs, total_));
  }
  void finish() { progress_->finish(); }

 private:
  bool in_time_;
  std::size_t total_, found_ = static_cast<std::size_t>(-1);
  double began_;
  std::unique_ptr<Progress> progress_;
};

KeptFailures kept_failures(const SearchResult& result, const FalsifyCampaign& campaign,
                           const FalsifyArguments& arguments, const SearchOptions& search,
                           const std::string& identity) {
  KeepOptions options;
  options.count = search.max_failures;
  options.shrink = {arguments.fairness, arguments.max_runs, InterruptGuard::raised};
  ShrunkFile shrunk(arguments.output, identity, options.shrink, arguments.campaign.existing);
  options.known = &shrunk;
  options.notify = print_notice;
  const auto progress = make_terminal_progress(arguments.campaign.quiet);
  auto kept = shrink_found(result.state.failures, campaign.setup, options, *progress);
  if (!kept) throw Interrupted("the same command continues");
  return std::move(*kept);
}

void search_verb(SearchArguments& arguments) {
  FalsifyArguments& common = arguments.common;
  SearchOptions& options = arguments.search;
  IniFile ini = load_campaign_ini(common.campaign);
  if (!arguments.against.empty()) common.witnesses = {add_reference(ini, arguments)};
  excuse_unnamed_witnesses(common);
  refuse_output_over_inputs(common.output, ini);
  const FalsifyCampaign campaign = read_falsify_campaign(ini, common);
  const bool needs_other =
      arguments.all_outcomes || campaign.setup.people.count > 0 || campaign.setup.walkers.count > 0;
  if (needs_other && !campaign.setup.has_witness() &&
      common.fairness.witness != NeedsWitness::Never)
    throw usage_error("--witness", "there is no other method in the campaign",
                      "--witness METHOD, or --no-witness");
  make_output_folder(common.output);
  const FileLock lock(common.output + "/search.state", common.campaign.take_over, print_notice);
  options.seed = common.campaign.seed.value_or(campaign.setup.seed);
  options.runs = arguments.runs.value_or(options.minutes > 0 ? 0 : kDefaultRuns);
  options.workers = campaign_workers(campaign.config, common.campaign);
  options.fairness = common.fairness;
  options.probe = !arguments.against.empty();
  options.outcomes = severe_outcomes();
  if (arguments.all_outcomes)
    options.outcomes.insert(options.outcomes.end(), {Outcome::Stuck, Outcome::Timeout});
  const std::string identity = search_identity(hash_of_methods(campaign), campaign.setup, options);
  const StateFile file(common.output, identity);
  options.known = file.load(common.campaign.existing);
  const InterruptGuard guard;
  SearchProgress progress(options, common.campaign.quiet);
  options.interrupted = InterruptGuard::raised;
  options.on_runs = [&](std::size_t runs) { progress.advance(runs); };
  options.save = [&](const SearchState& state) {
    file.save(state);
    progress.show(state);
  };
  const SearchResult result = search(campaign.setup, options);
  progress.finish();
  if (!result.complete)
    throw Interrupted(std::to_string(result.state.runs()) +
                      " runs are kept; the same command continues");
  KeptFailures kept = kept_failures(result, campaign, common, options, identity);
  std::vector<Failure>& failures = kept.failures;
  name_failures(failures, common.method);
  write_output(failures, campaign, common.output, search_json(result, kept, options.seed));
  NeighborOptions neighbors;
  neighbors.fairness = options.fairness;
  neighbors.seed = options.seed;
  neighbors.interrupted = InterruptGuard::raised;
  if (!find_neighbors(failures, campaign.setup, neighbors))
    throw Interrupted("the same command continues");
  const std::vector<ReportedCluster> clusters = report_clusters(failures, campaign, common);
  std::cout << search_text(result, kept, options);
  for (const Failure& failure : failures)
    std::cout << "\n" << failure_text(failure, campaign.setup);
  if (!failures.empty())
    std::cout << clusters_text(clusters, common.output) << "\nshow one  "
              << show_command(failures[0], campaign.setup, common.output) << "\n";
}

}  // namespace

void define_search(CLI::App& app) {
  static SearchArguments arguments;
  CampaignArguments& campaign = arguments.common.campaign;
  CLI::App* verb = app.add_subcommand(
      "search",
      "Search scenarios in which the method collides, or fails where a witness reaches the goal; "
      "the same command continues a search that was interrupted");
  add_argument(*verb, {"campaign", "-c,--config", "The campaign's .ini"}, campaign.config);
  complete_with(verb->add_option("--method", arguments.common.method, "The method that is tested")
                    ->required(),
                known_methods);
  add_falsify_options(*verb, arguments.common);
  CLI::Option* surrogate = verb->add_option(
      "--surrogate", arguments.common.surrogate,
      "A surrogate: a cheap method with similar failures, which preselects random scenarios for "
      "adaptive runs");
  complete_with(surrogate, known_methods);
  CLI::Option* against = verb->add_option(
      "--against", arguments.against,
      "The only witness: a method, or a library (.so) with an earlier version of a compiled method "
      "and the same parameters");
  against->excludes("--witness")->excludes(surrogate);
  complete_with(against, known_methods);
  verb->add_flag("--all-outcomes", arguments.all_outcomes,
                 "Also count stuck and timeout, which are frequent, as failures");
  verb->add_option(
          "--failures", arguments.search.max_failures,
          "Stop after the round that reaches this many failures, and report as many distinct "
          "ones")
      ->check(above_zero())
      ->capture_default_str();
  CLI::Option* runs =
      verb->add_option("--runs", arguments.runs, "Budget: runs of the method (default 10000)")
          ->check(above_zero());
  verb->add_option("--minutes", arguments.search.minutes,
                   "Budget: wall-clock time, of each execution of the command")
      ->check(above_zero())
      ->excludes(runs);
  verb->add_option("--seed", campaign.seed, "Seed instead of [campaign] seed");
  add_jobs_option(*verb, campaign.jobs, "Worker processes");
  add_existing_options(*verb, campaign.existing, campaign.take_over);
  verb->callback([] { search_verb(arguments); });
}

}  // namespace slalom
