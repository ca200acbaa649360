// SPDX-License-Identifier: BSD-3-Clause
#include "figure.h"
#include "figure_file.h"
#include "warnings.h"

#include <slalom/analysis/bins.h>
#include <slalom/analysis/common_scenarios.h>
#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/summary.h>
#include <slalom/app/campaign_names.h>
#include <slalom/app/checks.h>
#include <slalom/app/completion.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/find_run.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/io/svg_animation.h>
#include <slalom/metrics/metric.h>
#include <slalom/report/figures.h>
#include <slalom/report/report.h>
#include <slalom/results/privileged.h>
#include <slalom/simulation/evaluate_trajectory.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <tuple>

namespace slalom {
namespace {

struct FigureArguments {
  std::string results, output, profile, ranks, cell, scenario, animate, method;
  std::string metric, by, box, distribution, scatter, labels;
  bool outcomes = false, difficulty = false, common = false;
  int count = 12, pixels = 0;
  FigureStyle style;
  bool quiet = false;
};

using Labels = std::map<std::string, std::string>;

Labels read_labels(const std::string& text, const std::vector<std::string>& methods) {
  Labels labels;
  for (const std::string& item : split(text, ',')) {
    const std::size_t equal = item.find('=');
    const std::string method = trim(item.substr(0, equal));
    const std::string label = equal == std::string::npos ? "" : trim(item.substr(equal + 1));
    if (label.empty()) throw usage_error("--labels", "'" + item + "' has no label", "METHOD=LABEL");
    if (!contains(methods, method))
      throw usage_error("--labels", "no runs of '" + method + "'", expected_name(method, methods));
    if (!labels.emplace(method, label).second)
      throw usage_error("--labels", "'" + method + "' is labeled twice", "one label per method");
  }
  std::set<std::string> shown;
  for (const std::string& method : methods) {
    const auto found = labels.find(method);
    const std::string& label = found == labels.end() ? method : found->second;
    if (!shown.insert(label).second)
      throw usage_error("--labels", "two methods would be called '" + label + "'",
                        "a label of its own for each method");
  }
  return labels;
}

/// Draws runs of a result file.
class RunFigures {
 public:
  explicit RunFigures(const FigureArguments& arguments)
      : arguments_(arguments),
        file_(ResultFile::open(arguments.results)),
        runs_(read_results(arguments.results)),
        options_(report_options(runs_)) {
    if (!arguments.method.empty() && !contains(runs_.methods, arguments.method))
      throw usage_error("--method", "no runs of '" + arguments.method + "'",
                        expected_name(arguments.method, runs_.methods));
  }

  std::string of_scenario() const {
    std::set<std::uint32_t> chosen;
    for (std::uint32_t i = 0; i < runs_.scenario_hashes.size(); ++i)
      if (runs_.scenario_names[i] == arguments_.scenario ||
          (arguments_.scenario.size() >= 4 &&
           starts_with(runs_.scenario_hashes[i], arguments_.scenario)))
        chosen.insert(i);
    if (chosen.size() != 1)
      throw usage_error("--scenario", chosen.empty() ? "no such scenario" : "ambiguous",
                        "the name of a scenario, or the first digits of its id");
    return pictures(chosen);
  }

  std::string of_cell() const {
    const BinSpec spec = parse_bin_spec(arguments_.cell, "--cell");
    if (spec.kind != BinSpec::Kind::Edges || spec.edges.size() != 2)
      throw usage_error("--cell", "is not one bin", "DESCRIPTOR:LOW,HIGH");
    const Bin bin = make_bins(spec, runs_).front();
    const RunValues values(runs_, spec.descriptor);
    std::set<std::uint32_t> chosen;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      if (chosen.size() == static_cast<std::size_t>(arguments_.count)) break;
      if (is_drawn(run) && !values.is_na(run) && bin.contains(values(run)))
        chosen.insert(runs_.scenario[run]);
    }
    if (chosen.empty()) throw usage_error("--cell", "contains no runs", "a bin with runs");
    return pictures(chosen);
  }

  std::string animated() const {
    const RunRecord run = find_run(file_, arguments_.animate);
    const Trajectory trajectory = file_.read_trajectory(run);
    const References references = file_.read_references(run.scenario_hash);
    SceneOptions options = scene_options();
    if (options.max_pixels == 0) options.max_pixels = 320;
    options.references = &references;
    options.trajectories.push_back(drawn(run));
    const Scenario scenario = file_.read_scenario(run.scenario_hash);
    Movers movers;
    if (!scenario.people().empty() && !trajectory.samples.empty()) {
      movers = movers_along(World(scenario, options_.simulation.resolution), options_.robot,
                            options_.simulation, trajectory, options_.people);
      options.movers = &movers;
    }
    return render_animated_svg(scenario, options, trajectory) + "\n";
  }

 private:
  bool is_drawn(std::size_t run) const {
    return arguments_.method.empty() || runs_.methods[runs_.method[run]] == arguments_.method;
  }

  SceneOptions scene_options() const {
    SceneOptions options;
    options.max_pixels = arguments_.pixels;
    options.robot_radius = options_.robot.shape().enclosing_radius();
    return options;
  }

  /// A run in the color of its method in reports.
  SceneTrajectory drawn(const RunRecord& run) const {
    const auto method = std::find(runs_.methods.begin(), runs_.methods.end(), run.method);
    return {run.method, file_.read_trajectory(run).path(),
            from_stored_name<Outcome>("outcome", run.outcome),
            method_color(static_cast<std::size_t>(method - runs_.methods.begin()))};
  }

  std::string pictures(const std::set<std::uint32_t>& chosen) const {
    std::vector<References> references;
    references.reserve(chosen.size());  // the figures refer to them
    std::vector<ScenarioFigure> figures;
    for (const std::uint32_t index : chosen) {
      const std::string& hash = runs_.scenario_hashes[index];
      references.push_back(file_.read_references(hash));
      figures.push_back({file_.read_scenario(hash), scene_options()});
      figures.back().options.references = &references.back();
      for (const RunRecord& run : file_.read_runs(hash))
        if (arguments_.method.empty() || run.method == arguments_.method)
          figures.back().options.trajectories.push_back(drawn(run));
    }
    FigureStyle style = arguments_.style;
    style.labels = read_labels(arguments_.labels, runs_.methods);
    return scenario_figure(figures, style);
  }

  const FigureArguments& arguments_;
  ResultFile file_;
  ResultTable runs_;
  ReportOptions options_;
};

std::string metric_by_bins(const ResultTable& runs, const FigureArguments& arguments,
                           const AnalysisOptions& options, const FigureStyle& style) {
  const std::vector<BinSpec> by = parse_bin_specs(arguments.by, "--by");
  if (by.size() == 1) {
    const auto tables = build_cross_tables(runs, by, {arguments.metric}, options);
    return bins_figure(tables, tables.front().columns.front(), style);
  }
  if (by.size() != 2)
    throw usage_error("--by", "has " + count_text(by.size(), "descriptor"),
                      "bins of one descriptor for lines, or of two for a map");
  std::vector<DescriptorMap> maps;
  for (const std::string& method : runs.methods)
    maps.push_back(build_descriptor_map(runs, method, by[0], by[1], arguments.metric, options));
  return map_figure(maps, style);
}

/// Keeps the runs in the scenarios in which all runs of all methods have the metric that is drawn.
void keep_common_scenarios(ResultTable& runs, const FigureArguments& arguments) {
  std::string id;
  for (const std::string* metric : {&arguments.metric, &arguments.box, &arguments.distribution})
    if (!metric->empty()) id = *metric;
  if (id.empty()) throw usage_error("--common", "needs a metric", "--metric, --box or --ecdf");
  const Column column = resolve_columns(runs, {id}).front();
  const std::vector<bool> common = find_common_scenarios(runs, *find_metric(runs, column.info.id));
  const auto count = static_cast<std::size_t>(std::count(common.begin(), common.end(), true));
  if (count == 0)
    throw usage_error("--common", "no scenario in which every run has " + column.info.id,
                      "a metric that all methods have in some scenario");
  if (!arguments.quiet)
    std::cerr << "in " << count << " of " << count_text(common.size(), "scenario")
              << ", where every run has " << column.info.id << "\n";
  keep_runs_in(runs, common);
}

std::string figure(const FigureArguments& arguments) {
  if (!arguments.scenario.empty()) return RunFigures(arguments).of_scenario();
  if (!arguments.cell.empty()) return RunFigures(arguments).of_cell();
  if (!arguments.animate.empty()) return RunFigures(arguments).animated();
  ResultTable runs = read_results(arguments.results);
  warn_of_missing(arguments.results, runs);
  FigureStyle style = arguments.style;
  style.labels = read_labels(arguments.labels, runs.methods);
  mark_privileged(runs);
  const AnalysisOptions options = report_options(runs).analysis;
  if (arguments.common) keep_common_scenarios(runs, arguments);
  if (!arguments.metric.empty()) return metric_by_bins(runs, arguments, options, style);
  if (arguments.outcomes) return outcome_figure(build_summary(runs, {"success"}, options), style);
  if (arguments.difficulty)
    return difficulty_figure(build_difficulty(runs, "success", options), runs.methods, style);
  if (!arguments.box.empty()) return box_figure(runs, arguments.box, style);
  if (!arguments.distribution.empty())
    return distribution_figure(runs, arguments.distribution, style);
  if (!arguments.scatter.empty()) {
    const std::vector<std::string> ids = split(arguments.scatter, ',');
    if (ids.size() != 2) throw usage_error("--scatter", "is not two ids", "X,Y");
    return scatter_figure(runs, ids[0], ids[1], style);
  }
  if (!arguments.profile.empty())
    return profile_figure(build_profiles(runs, arguments.profile), style);
  return rank_figure(build_method_ranks(runs, arguments.ranks, options), style);
}

void run(const FigureArguments& arguments) {
  if (!arguments.metric.empty() && arguments.by.empty())
    throw usage_error("--metric " + arguments.metric, "needs --by", "--by density:q4");
  if (!arguments.animate.empty() && !ends_with(arguments.output, ".svg"))
    throw usage_error("--output", "an animation is an SVG", "FILE.svg");
  write_figure(figure(arguments), arguments.output);
  if (!arguments.quiet) std::cerr << arguments.output << ": written\n";
}

}  // namespace

void define_figure(CLI::App& app) {
  static FigureArguments arguments;
  CLI::App* verb = app.add_subcommand("figure", "Draw a figure for a paper as SVG, PDF or PNG");
  verb->add_option("results", arguments.results, "A result file (.results)")->required();
  CLI::Option_group* kind = verb->add_option_group("What is drawn");
  CLI::Option* metric = kind->add_option(
      "--metric", arguments.metric,
      "This metric over the bins of --by: lines over one descriptor, a map of two");
  complete_with(metric, [](const Words&) { return metric_ids(); });
  kind->add_flag("--outcomes", arguments.outcomes, "The outcomes of each method as bars");
  kind->add_flag("--difficulty", arguments.difficulty,
                 "Abilities of methods beside the difficulties of scenarios");
  for (const auto& [name, id, help] :
       {std::tuple{"--box", &arguments.box, "Quartiles of this metric for each method"},
        {"--ecdf", &arguments.distribution, "The distribution of this metric for each method"}})
    complete_with(kind->add_option(name, *id, help), [](const Words&) { return metric_ids(); });
  kind->add_option("--scatter", arguments.scatter,
                   "A point per run: two descriptors or metrics, X,Y");
  kind->add_option("--scenario", arguments.scenario,
                   "The runs in a scenario: its name or the first digits of its id");
  kind->add_option("--cell", arguments.cell,
                   "The runs of a cell: a picture per scenario of DESCRIPTOR:LOW,HIGH");
  kind->add_option("--animate", arguments.animate,
                   "A run as an animated SVG: SCENARIO/METHOD/REPETITION");
  kind->add_option("--profile", arguments.profile, "Performance profiles of this metric");
  kind->add_option("--ranks", arguments.ranks, "Critical-difference diagram of this metric");
  kind->require_option(1);
  complete_with(verb->add_option("--by", arguments.by,
                                 "With --metric: bins of a descriptor, such as density:q4 or "
                                 "density:0,0.1,0.2, or of two separated by ';'")
                    ->needs(metric),
                [](const Words&) { return descriptor_ids(); });
  verb->add_option("--method", arguments.method, "With --scenario or --cell: only this method");
  verb->add_option("--count", arguments.count, "With --cell: at most this number of scenarios")
      ->check(in_range(1, 200))
      ->capture_default_str();
  verb->add_option("--pixels", arguments.pixels,
                   "Longer side of a scenario, pixels (default: as --width has room, else 320)")
      ->check(in_range(16, 10000));
  verb->add_flag("--common", arguments.common,
                 "With --metric, --box or --ecdf: only scenarios in which every run has a value");
  verb->add_option("--width", arguments.style.width, "Width of the figure, mm")
      ->check(in_range(30, 1000));
  verb->add_option("--font-size", arguments.style.font_size, "Size of the text, points")
      ->check(in_range(4, 40))
      ->capture_default_str();
  verb->add_option("--labels", arguments.labels,
                   "What methods are called, METHOD=LABEL,..., such as nd='ND [12]'");
  verb->add_option("-o,--output", arguments.output,
                   "A .svg file, or .pdf or .png (need rsvg-convert of the package librsvg2-bin)")
      ->required();
  verb->add_flag("--quiet", arguments.quiet, "No messages");
  verb->callback([] { run(arguments); });
}

}  // namespace slalom
