// SPDX-License-Identifier: BSD-3-Clause
#include "execute.h"

#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/campaign/run_draws.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/progress.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/map_import.h>

#include <map>
#include <memory>

namespace slalom {
namespace {

/// Reads each map once.
MapLoader caching_loader() {
  using Maps = std::map<std::string, mrpt::maps::COccupancyGridMap2D>;
  return [maps = std::make_shared<Maps>()](const std::string& path) {
    const auto found = maps->find(path);
    return found != maps->end() ? found->second
                                : maps->emplace(path, load_occupancy_grid(path)).first->second;
  };
}

/// Scenarios with values of the parameter.
class ScenarioDraws {
 public:
  explicit ScenarioDraws(const LimitJob& job) : job_(job), load_map_(caching_loader()) {
    const std::vector<WeightedGenerator>& families = job.config.sources.families;
    for (const WeightedGenerator& family : families) total_weight_ += family.weight;
    // Errors about a value before any run, and maps before workers are forked.
    RandomEngine engine(1);
    for (const double value : {job.question.bins.from, job.question.bins.to})
      sources_at(value, engine);
  }

  std::optional<RunDraw> draw(LimitPhase phase, const BinRange& bins, std::size_t index) const {
    const std::string label = "limit/" + std::string(to_string(phase)) + "/" +
                              std::to_string(bins.first) + "-" + std::to_string(bins.end);
    RandomEngine engine(derive_seed(job_.config.options.seed, label, index));
    const auto [ini, sources] = sources_at(job_.question.bins.draw(bins, engine), engine);
    const auto silent = make_silent_progress();
    try {
      std::vector<Scenario> scenarios = collect_scenarios(sources, load_map_, *silent);
      RunDraw draw{std::move(scenarios.at(0))};
      if (job_.question.parameter.family.empty()) draw.options = read_campaign_options(ini);
      return draw;
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::Job) throw;
      return std::nullopt;
    }
  }

 private:
  std::pair<IniFile, ScenarioSources> sources_at(double value, RandomEngine& engine) const {
    IniFile ini = job_.ini;
    job_.question.parameter.set(ini, value);
    ini.set("scenarios", "generator", choose_family(engine));
    ini.set("scenarios", "weights", "");
    ini.set("scenarios", "count", "1");
    const RobotModel robot = read_robot_model(ini);
    read_sensor_model(ini);
    ScenarioSources sources = read_scenario_sources(
        ini, {robot.radius, job_.config.options.simulation.resolution, engine()}, load_map_);
    return {std::move(ini), std::move(sources)};
  }

  /// With a probability proportional to its weight.
  std::string choose_family(RandomEngine& engine) const {
    const std::vector<WeightedGenerator>& families = job_.config.sources.families;
    double rest = uniform_real(engine, 0, total_weight_);
    for (const WeightedGenerator& family : families) {
      rest -= family.weight;
      if (rest < 0) return family.name_prefix;
    }
    return families.back().name_prefix;
  }

  const LimitJob& job_;
  MapLoader load_map_;
  double total_weight_ = 0;
};

void set_sources(IniFile& ini, const Parameter& parameter) {
  if (!parameter.family.empty()) {
    for (const char* key : {"list", "maps", "weights"}) ini.remove("scenarios", key);
    return ini.set("scenarios", "generator", parameter.family, "--of ");
  }
  for (const char* key : {"list", "maps"})
    if (ini.get("scenarios", key))
      throw usage_error(ini.where("scenarios", key), "scenarios of a limit are drawn for each run",
                        "generator only");
}

void require_probability(const std::string& option, double value) {
  if (!(value > 0 && value < 1))
    throw usage_error(option + " " + format_number(value), "is not a probability that can be shown",
                      "between 0 and 1, both excluded");
}

void check(const LimitQuestion& question, double resolution) {
  const LimitOptions& search = question.search;
  require_probability("--reliability", search.reliability);
  require_probability("--confidence", search.confidence);
  const std::size_t needed = runs_without_failure(search.reliability, search.confidence);
  const std::pair<const char*, std::size_t> kBudgets[] = {{"--budget", search.budget},
                                                          {"--max-per-step", search.max_per_step}};
  for (const auto& [option, runs] : kBudgets)
    if (runs < needed)
      throw usage_error(std::string(option) + " " + std::to_string(runs),
                        "a claim of " + format_number(search.reliability) + " at " +
                            format_number(search.confidence) + " needs at least " +
                            std::to_string(needed) + " runs without a failure",
                        "at least " + std::to_string(needed));
  if (question.parameter.is_length() && question.bins.step < 2 * resolution - 1e-9)
    throw usage_error(
        "--step " + format_number(question.bins.step),
        "is less than two cells of " + format_number(resolution) + " m (simulation.resolution)",
        "at least " + format_number(2 * resolution) +
            ", or --set simulation.resolution=" + format_number(question.bins.step / 2));
}

}  // namespace

LimitJob make_limit_job(LimitQuestion question, IniFile ini) {
  require_method(ini, "--method", question.method);
  question.bins.integer = question.parameter.integer;
  question.bins.unit = question.parameter.unit;
  question.search.bins = question.bins.count();
  for (const std::string& section : ini.sections())
    if (starts_with(section, "method.") && section != "method." + question.method)
      for (const std::string& key : ini.keys(section)) ini.remove(section, key);
  ini.set("campaign", "methods", question.method);
  set_sources(ini, question.parameter);
  CampaignConfig config = read_campaign(ini);
  check(question, config.options.simulation.resolution);
  LimitJob job{std::move(question), std::move(ini), std::move(config)};
  const ScenarioDraws checked(job);
  check_campaign(job.config);
  return job;
}

LimitAnswer execute(const LimitJob& job, const CampaignArguments& arguments) {
  const ScenarioDraws draws(job);
  const InterruptGuard guard;
  const auto progress = make_terminal_progress(arguments.quiet);
  const int workers = campaign_workers(job.config, arguments);
  Hasher outcomes;
  const RunBins run = [&](LimitPhase phase, const BinRange& bins, std::size_t max_runs,
                          const std::function<bool(bool)>& receive) {
    std::size_t done = 0;
    progress->start(std::string(to_string(phase)) + " in " + job.question.bins.text(bins),
                    max_runs);
    const bool complete = run_draws(
        job.config.methods.at(0), job.config.options,
        [&](std::size_t index) { return draws.draw(phase, bins, index); }, max_runs,
        {workers, InterruptGuard::raised},
        [&](const DrawnRun& drawn) {
          outcomes.add(to_string(drawn.outcome)).add(drawn.scenario_hash);
          outcomes.add(drawn.trajectory_hash);
          progress->advance(++done);
          return receive(drawn.outcome == Outcome::Success);
        });
    progress->finish();
    return complete;
  };
  LimitAnswer answer{find_limit(job.question.search, run), ""};
  const Bins& bins = job.question.bins;
  if (answer.result.exchanged)
    throw usage_error("--from " + format_number(bins.from) + " --to " + format_number(bins.to),
                      "the method succeeds at " + bins.value_text(bins.to) + ", not at " +
                          bins.value_text(bins.from),
                      "the easy end first");
  if (!answer.result.complete) throw Interrupted("nothing was written");
  answer.outcomes = outcomes.hex();
  return answer;
}

}  // namespace slalom
