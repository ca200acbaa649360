#include "campaign_recorder.h"

#include <slalom/analysis/analysis_section.h>
#include <slalom/analysis/precision_rule.h>
#include <slalom/app/sequential_campaign.h>
#include <slalom/commands/describe_scenario.h>
#include <slalom/core/error.h>
#include <slalom/core/options.h>
#include <slalom/core/text.h>
#include <slalom/generation/parallel.h>
#include <slalom/io/result_columns.h>

#include <algorithm>

namespace slalom {
namespace {

Value describe(const Scenario& scenario, const std::string& id, const CampaignOptions& options) {
  DescribeOptions describe;
  describe.ids = {id};
  describe.robot = options.setup.robot.shape();
  describe.sensor_range = options.setup.sensor.max_range;
  describe.resolution = options.setup.simulation.resolution;
  describe.exact_confinement = options.exact_confinement;
  MemoryDescriptorStore store;
  return describe_scenario(scenario, describe, store).front().value;
}

/// The scenarios of one bin that have not been driven yet, in the order of the pool.
struct BinPool {
  Bin bin;
  std::vector<std::size_t> scenarios;
  std::size_t taken = 0;

  std::size_t next_batch() const {
    return std::min(scenarios.size() - taken, taken == 0 ? kFirstBatch : (taken + 1) / 2);
  }
};

/// The pool sorted into the bins of the rule, whose edges are fixed here.
class Pool {
 public:
  Pool(std::vector<Scenario> scenarios, PrecisionRule& rule, const CampaignOptions& options,
       int jobs)
      : scenarios_(std::move(scenarios)) {
    if (rule.rows.kind == BinSpec::Kind::All) {
      bins_.push_back({});
      for (std::size_t i = 0; i < scenarios_.size(); ++i) bins_[0].scenarios.push_back(i);
      return;
    }
    const std::vector<Value> values = parallel_map(scenarios_.size(), jobs, [&](std::size_t i) {
      return describe(scenarios_[i], rule.rows.descriptor, options);
    });
    for (const Bin& bin : bins_of(values, rule.rows)) bins_.push_back({bin, {}, 0});
    for (std::size_t i = 0; i < values.size(); ++i) sort_in(i, values[i]);
    rule.rows = with_edges(rule.rows.descriptor, all_bins());
  }

  std::vector<BinPool>& bins() { return bins_; }

  /// The next scenarios of these bins.
  std::vector<Scenario> draw(const std::vector<bool>& open) {
    std::vector<std::size_t> chosen;
    for (std::size_t b = 0; b < bins_.size(); ++b) {
      if (!open[b]) continue;
      BinPool& bin = bins_[b];
      const std::size_t n = bin.next_batch();
      const auto first = bin.scenarios.begin() + static_cast<std::ptrdiff_t>(bin.taken);
      chosen.insert(chosen.end(), first, first + static_cast<std::ptrdiff_t>(n));
      bin.taken += n;
    }
    std::sort(chosen.begin(), chosen.end());
    std::vector<Scenario> batch;
    for (const std::size_t i : chosen) batch.push_back(scenarios_[i]);
    return batch;
  }

 private:
  std::vector<Bin> bins_of(const std::vector<Value>& values, const BinSpec& spec) const {
    ResultTable table;
    table.quantities[spec.descriptor] = descriptor(spec.descriptor).info();
    for (std::size_t i = 0; i < values.size(); ++i) {
      ScenarioRecord record{scenarios_[i].hash(), scenarios_[i].name(), {}};
      record.descriptors[spec.descriptor] = {table.quantities[spec.descriptor].version, values[i]};
      table.scenarios[record.hash] = record;
    }
    return make_bins(spec, table);
  }

  void sort_in(std::size_t scenario, const Value& value) {
    if (value.is_na()) return;
    for (BinPool& bin : bins_) {
      if (bin.bin.contains(value.number())) return bin.scenarios.push_back(scenario);
    }
  }

  std::vector<Bin> all_bins() const {
    std::vector<Bin> bins;
    for (const BinPool& bin : bins_) bins.push_back(bin.bin);
    return bins;
  }

  std::vector<Scenario> scenarios_;
  std::vector<BinPool> bins_;
};

/// The rule, checked against what the campaign computes, before anything runs.
PrecisionRule checked_rule(const std::string& text, const CampaignOptions& options) {
  const PrecisionRule rule = parse_precision_rule(text);
  const auto expect = [](const std::string& id, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), id) != known.end()) return;
    const std::string nearest = nearest_name(id, known);
    throw usage_error("--until", "'" + id + "' is not computed by this campaign",
                      nearest.empty() ? "one of " + join(known, ", ") : "'" + nearest + "'");
  };
  std::vector<std::string> metrics = options.metrics;
  if (std::find(metrics.begin(), metrics.end(), "success") == metrics.end())
    metrics.emplace_back("success");
  expect(rule.metric, metrics);
  if (rule.rows.kind != BinSpec::Kind::All) expect(rule.rows.descriptor, options.descriptors);
  return rule;
}

/// What a look at the results needs of them.
std::vector<std::string> ids_of(const PrecisionRule& rule) {
  if (rule.rows.kind == BinSpec::Kind::All) return {rule.metric};
  return {rule.metric, rule.rows.descriptor};
}

/// Which bins some method is not known well enough in.
std::vector<bool> open_bins(const std::vector<PrecisionCell>& cells, std::size_t bins) {
  std::vector<bool> open(bins, false);
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!cells[i].reached) open[i % bins] = true;
  return open;
}

std::string ending(const std::vector<PrecisionCell>& cells, const std::string& why, int looks,
                   std::size_t runs) {
  const auto reached = std::count_if(cells.begin(), cells.end(),
                                     [](const PrecisionCell& cell) { return cell.reached; });
  return std::to_string(reached) + " of " + std::to_string(cells.size()) + " cells reached after " +
         std::to_string(runs) + " runs and " + std::to_string(looks) + " looks: " + why + "\n";
}

}  // namespace

SequentialReport run_until(const IniFile& ini, const CampaignArguments& arguments,
                           const SequentialArguments& sequential, std::vector<Scenario> scenarios,
                           const std::string& results_path) {
  const CampaignOptions options = read_campaign_options(ini);
  PrecisionRule rule = checked_rule(sequential.until, options);
  CampaignRecorder recorder(ini, arguments, scenarios, results_path, {{"until", sequential.until}});
  Pool pool(std::move(scenarios), rule, options, arguments.jobs);
  AnalysisOptions analysis;
  analysis.confidence = read_options<AnalysisSection>(ini, "analysis").confidence;

  SequentialReport report;
  std::vector<PrecisionCell> cells;
  std::vector<bool> open(pool.bins().size(), true);
  std::string why;
  std::size_t runs = 0;
  int looks = 0;
  while (why.empty()) {
    const std::vector<Scenario> batch = pool.draw(open);
    if (batch.empty()) {
      why = "there are no more scenarios for the others";
      break;
    }
    report.campaign.complete = recorder.run(batch);
    if (!report.campaign.complete) break;
    const RunColumns results = read_run_columns(results_path, ids_of(rule));
    runs = results.size();
    cells = precision_cells(results, rule, analysis, ++looks);
    open = open_bins(cells, pool.bins().size());
    report.reached = std::none_of(open.begin(), open.end(), [](bool is_open) { return is_open; });
    if (report.reached) why = "precise enough";
    if (why.empty() && sequential.max_runs > 0 && runs >= sequential.max_runs)
      why = "as many runs as were allowed";
  }
  report.campaign.problem = recorder.problem();
  report.text = render_precision_text(rule, cells) + ending(cells, why, looks, runs);
  return report;
}

}  // namespace slalom
