// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/adapters.h>
#include <slalom/app/block_runner.h>
#include <slalom/app/method_option.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/progress.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/methods/registry.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

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

ScenarioSources read_sources(const IniFile& ini, double resolution, const MapLoader& load_map) {
  const RobotModel robot = read_robot_model(ini);
  read_sensor_model(ini);
  ScenarioSources sources = read_scenario_sources(ini, source_context(robot, resolution), load_map);
  if (!sources.section.list.empty())
    throw usage_error(ini.where("scenarios", "list"), "scenarios are drawn for each run",
                      "generator and maps only");
  return sources;
}

/// The sources of one scenario: a family or a map, each as often as in a campaign.
ScenarioSources one_of(ScenarioSources sources, RandomEngine& engine) {
  ScenariosSection& section = sources.section;
  const std::vector<std::string> maps = split(section.maps, ',');
  double families = 0;
  for (const WeightedGenerator& family : sources.families) families += family.weight;
  const double weight_of_maps =
      static_cast<double>(maps.size()) * (sources.families.empty() ? 1 : section.pairs_per_map);
  const double scale = maps.empty() || families == 0 ? 1 : section.count / families;
  double rest = uniform_real(engine, 0, families * scale + weight_of_maps);
  section.count = section.pairs_per_map = 1;
  section.maps = "";
  for (WeightedGenerator& family : sources.families) {
    rest -= family.weight * scale;
    if (rest >= 0 && (!maps.empty() || &family != &sources.families.back())) continue;
    sources.context.seed = engine();
    family.seed = source_seed(sources.context.seed, family.name_prefix);
    sources.families = {WeightedGenerator(family)};
    return sources;
  }
  const double fraction = std::max(rest, 0.0) / weight_of_maps;
  section.maps = maps.at(std::min(
      maps.size() - 1, static_cast<std::size_t>(fraction * static_cast<double>(maps.size()))));
  section.generator = "";
  sources.families.clear();
  sources.context.seed = engine();
  return sources;
}

std::uint64_t digest_of(const DrawnRun& run) {
  const std::string hex = Hasher().add(run.scenario_hash).add(run.trajectory_hash).hex();
  return std::stoull(hex.substr(0, 16), nullptr, 16);
}

constexpr char kJournal[] = "slalom-certify journal ";
constexpr std::size_t kMaxInARow = 100;  ///< draws that are no runs

/// Whether a draw that the robot cannot solve is no run: nothing but chance is to blame.
bool draws_again(const RunStream& stream) {
  return stream.parameters.empty() && !stream.scenarios;
}

}  // namespace

std::string hash_of_streams(const std::map<std::string, std::string>& hashes) {
  Hasher hasher;
  for (const auto& [name, hash] : hashes) hasher.add(name).add(hash);
  return hasher.hex();
}

MethodCampaign read_method_campaign(IniFile ini, const std::string& method) {
  require_method(ini, "--method", method);
  ini.set("campaign", "methods", method);
  CampaignConfig config = read_campaign(ini);
  // Bases of filters and inner methods are sections of their own, which the campaign needs.
  const std::vector<std::string> needed = method_sections(ini, method);
  for (const std::string& section : ini.sections())
    if (starts_with(section, "method.") && !contains(needed, section))
      for (const std::string& key : ini.keys(section)) ini.remove(section, key);
  check_campaign(config);
  Manifest files = hash_method_files(config);
  ConfigureMethod configure = [ini, method](const std::map<std::string, std::string>& options) {
    IniFile changed = ini;
    for (const auto& [key, value] : options) set_method_option(changed, method, key, value);
    return all_adapters().read(changed, method);
  };
  return {std::move(ini),   std::move(config.options), std::move(config.methods.at(0)),
          std::move(files), config.one_worker,         std::move(configure)};
}

BlockRunner::BlockRunner(const MethodCampaign& campaign, BlockExecution execution)
    : campaign_(campaign), execution_(std::move(execution)), load_map_(caching_loader()) {
  if (!execution_.journal.empty()) read_journal();
}

void BlockRunner::check(const RunStream& stream) const {
  // Errors about a value, and maps before workers are forked.
  const double resolution = campaign_.options.simulation.resolution;
  IniFile low = stream.ini, high = stream.ini;
  for (const DrawnParameter& drawn : stream.parameters) {
    drawn.parameter.set(low, drawn.bins.edge(drawn.range.first));
    drawn.parameter.set(high, drawn.bins.hardest(drawn.range));
  }
  for (const IniFile& ini : {low, high}) {
    const ScenariosSection section = read_sources(ini, resolution, load_map_).section;
    for (const std::string& map : split(section.maps, ',')) load_map_(map);
    if (section.people.count > 0) {
      const CampaignOptions options = read_campaign_options(ini);
      check_period(options.people, options.simulation, location_in(ini, "people"));
    }
  }
}

std::optional<RunDraw> BlockRunner::draw(const RunStream& stream, std::size_t index) const {
  if (stream.scenarios) return RunDraw{stream.scenarios->at(index)};
  RandomEngine engine(derive_seed(campaign_.options.seed, stream.name, index));
  IniFile ini = stream.ini;
  bool own_options = false;
  for (const DrawnParameter& drawn : stream.parameters) {
    drawn.parameter.set(ini, drawn.bins.draw(drawn.range, engine));
    own_options = own_options || drawn.parameter.family.empty();
  }
  const ScenarioSources sources =
      one_of(read_sources(ini, campaign_.options.simulation.resolution, load_map_), engine);
  const auto silent = make_silent_progress();
  try {
    std::vector<Scenario> scenarios = collect_scenarios(sources, load_map_, *silent);
    RunDraw draw{std::move(scenarios.at(0))};
    if (own_options) draw.options = read_campaign_options(ini);
    return draw;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::Job) throw;
    return std::nullopt;
  }
}

void BlockRunner::run(const RunStream& stream, std::size_t max_runs, const ReceiveRun& receive) {
  if (max_runs == 0) return;
  Stream& kept = streams_[stream.name];
  std::size_t next = 0, runs = 0, in_a_row = 0;
  const auto pass_on = [&] {
    BlockRun run = kept.runs[next];
    run.index = next++;
    kept.passed = std::max(kept.passed, next);
    if (run.outcome == Outcome::UnsolvableScenario && draws_again(stream)) {
      if (++in_a_row < kMaxInARow) return true;
      throw job_error(stream.title,
                      "no solvable scenario in " + std::to_string(kMaxInARow) + " draws");
    }
    in_a_row = 0;
    return receive(run) && ++runs < max_runs;
  };
  while (next < kept.runs.size())
    if (!pass_on()) return;
  const auto progress = make_terminal_progress(execution_.quiet);
  progress->start(stream.title, max_runs);
  for (bool more = true; more;) {  // as many draws as runs are missing, until none is
    const std::size_t first = next;
    const bool complete = run_draws(
        stream.method.value_or(campaign_.method), read_campaign_options(stream.ini),
        [&](std::size_t index) { return draw(stream, first + index); }, max_runs - runs,
        {execution_.workers, execution_.interrupted, execution_.metric},
        [&](const DrawnRun& drawn) {
          kept.runs.push_back({drawn.outcome, drawn.value, digest_of(drawn)});
          write_journal(stream.name, kept.runs.back());
          if (const std::string outcome(to_string(drawn.outcome));
              first_failure_.empty() && is_method_failure(outcome))
            first_failure_ = outcome + ": " + drawn.detail;
          cycle_time_ = std::max(cycle_time_.value_or(0), drawn.cycle_time);
          more = pass_on();
          progress->advance(runs);
          return more;
        });
    if (!complete) break;
    if (!more) return progress->finish();
  }
  progress->finish();
  throw Interrupted(execution_.journal.empty() ? "nothing was written"
                                               : "the same command continues");
}

std::size_t BlockRunner::redrawn(const RunStream& stream) const {
  const Stream& kept = streams_.at(stream.name);
  return static_cast<std::size_t>(std::count_if(
      kept.runs.begin(), kept.runs.begin() + static_cast<std::ptrdiff_t>(kept.passed),
      [](const BlockRun& run) { return run.outcome == Outcome::UnsolvableScenario; }));
}

std::string BlockRunner::method_failures() const {
  std::size_t runs = 0, failed = 0;
  std::string first;
  for (const auto& [name, kept] : streams_)
    for (std::size_t i = 0; i < kept.passed; ++i) {
      const std::string outcome(to_string(kept.runs[i].outcome));
      ++runs;
      if (is_method_failure(outcome) && failed++ == 0) first = outcome;
    }
  if (failed == 0) return "";
  if (!first_failure_.empty()) first = first_failure_;  // The journal has no details.
  if (failed == runs)
    throw usage_error("method " + campaign_.method.name, "every run ended with " + first,
                      "a method that works");
  return count_text(failed, "run") + " ended by errors of the method, such as " + first;
}

std::string BlockRunner::hash(const std::string& stream) const {
  Hasher hasher;
  const Stream& kept = streams_.at(stream);
  for (std::size_t i = 0; i < kept.passed; ++i)
    hasher.add(to_string(kept.runs[i].outcome)).add(kept.runs[i].digest);
  return hasher.hex();
}

std::string BlockRunner::hash_all(const std::string& prefix) const {
  std::map<std::string, std::string> hashes;
  for (const auto& [name, kept] : streams_)
    if (kept.passed > 0 && starts_with(name, prefix)) hashes[name] = hash(name);
  return hash_of_streams(hashes);
}

/// Line by line: the name of a stream after "@", or outcome, digest and value of its next run.
void BlockRunner::read_journal() {
  const std::string head = kJournal + execution_.identity + "\n";
  std::string text;
  if (std::ifstream(execution_.journal)) text = read_file(execution_.journal, "a journal");
  text.resize(text.rfind('\n') + 1);  // A line that was not finished is none.
  if (!text.empty() && !starts_with(text, head))
    throw usage_error(execution_.journal, "is of another question",
                      "another -o, or that this file is removed");
  std::istringstream lines(text.empty() ? "" : text.substr(head.size()));
  for (std::string line; std::getline(lines, line);) {
    if (starts_with(line, "@")) {
      journal_stream_ = line.substr(1);
      continue;
    }
    std::istringstream words(line);
    std::string name, value;
    BlockRun run;
    words >> name >> std::hex >> run.digest >> value;
    const std::optional<Outcome> outcome = from_name<Outcome>(name);
    double number = 0;
    if (value != "-" && parse_number(value, number)) run.value = number;
    if (!words || !outcome || journal_stream_.empty() || (value != "-" && !run.value))
      throw file_error(execution_.journal, "damaged line '" + line + "'",
                       "the journal of this question, or none: delete it to start again");
    run.outcome = *outcome;
    streams_[journal_stream_].runs.push_back(run);
  }
  journal_text_ = text.empty() ? head : text;
}

void BlockRunner::remove_journal() {
  journal_.close();
  if (!execution_.journal.empty()) std::filesystem::remove(execution_.journal);
}

/// Begins the file with the first new run: a question that is refused leaves none.
void BlockRunner::write_journal(const std::string& stream, const BlockRun& run) {
  if (execution_.journal.empty()) return;
  if (!journal_.is_open()) {
    journal_.open(execution_.journal, std::ios::trunc);
    journal_ << journal_text_;
    journal_text_.clear();
  }
  if (stream != journal_stream_) journal_ << '@' << stream << '\n';
  journal_stream_ = stream;
  journal_ << to_string(run.outcome) << ' ' << std::hex << run.digest << ' '
           << (run.value ? format_number(*run.value) : "-") << '\n';
  // Flushed for each run: what is lost in a kill is executed again, but a full disk is told at
  // once.
  if (!journal_.flush())
    throw file_error(execution_.journal, "cannot be written",
                     "a folder that is writable, on a disk that is not full");
}

}  // namespace slalom
