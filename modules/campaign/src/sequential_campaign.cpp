#include <slalom/campaign/describe_scenario.h>
#include <slalom/campaign/sequential_campaign.h>
#include <slalom/core/error.h>
#include <slalom/core/parallel.h>
#include <slalom/core/text.h>
#include <slalom/io/read_results.h>

#include <algorithm>
#include <set>

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

/// The scenarios of one bin in the order of the pool; the first `taken` have been run.
struct BinScenarios {
  Bin bin;
  std::vector<std::size_t> scenarios;
  std::size_t taken = 0;

  std::size_t batch_size() const {
    return std::min(scenarios.size() - taken, taken == 0 ? kFirstBatch : (taken + 1) / 2);
  }
};

/// The scenarios of the pool by bin. Fixes the edges of the rule's bins.
class ScenarioPool {
 public:
  ScenarioPool(std::vector<Scenario> scenarios, PrecisionRule& rule, const CampaignOptions& options,
               const Execution& execution)
      : scenarios_(std::move(scenarios)) {
    if (rule.rows.kind == BinSpec::Kind::All) {
      bins_.push_back({});
      for (std::size_t i = 0; i < scenarios_.size(); ++i) bins_[0].scenarios.push_back(i);
      return;
    }
    const auto values = parallel_map(scenarios_.size(), execution.workers, [&](std::size_t i) {
      if (execution.is_interrupted()) return Value::na("interrupted");
      return describe(scenarios_[i], rule.rows.descriptor, options);
    });
    if (execution.is_interrupted()) return;
    for (const Bin& bin : bins_of(values, rule.rows)) bins_.push_back({bin, {}, 0});
    for (std::size_t i = 0; i < values.size(); ++i) assign_to_bin(i, values[i]);
    rule.rows = with_edges(rule.rows.descriptor, all_bins());
  }

  std::vector<BinScenarios>& bins() { return bins_; }

  /// The next batch of scenarios from the open bins.
  std::vector<Scenario> next_batch(const std::vector<bool>& open) {
    std::vector<std::size_t> chosen;
    for (std::size_t b = 0; b < bins_.size(); ++b) {
      if (!open[b]) continue;
      BinScenarios& bin = bins_[b];
      const std::size_t n = bin.batch_size();
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
  static std::vector<Bin> bins_of(const std::vector<Value>& values, const BinSpec& spec) {
    ResultTable table;
    ValueColumn& column = table.descriptors.emplace_back(descriptor(spec.descriptor).info);
    for (const Value& value : values) column.add(value);
    return make_bins(spec, table);
  }

  void assign_to_bin(std::size_t scenario, const Value& value) {
    if (value.is_na()) return;
    for (BinScenarios& bin : bins_) {
      if (bin.bin.contains(value.number())) return bin.scenarios.push_back(scenario);
    }
  }

  std::vector<Bin> all_bins() const {
    std::vector<Bin> bins;
    for (const BinScenarios& bin : bins_) bins.push_back(bin.bin);
    return bins;
  }

  std::vector<Scenario> scenarios_;
  std::vector<BinScenarios> bins_;
};

/// Throws for ids that the campaign does not compute.
void check_ids(const PrecisionRule& rule, const CampaignOptions& options) {
  const auto expect = [](const std::string& id, const std::vector<std::string>& known) {
    if (contains(known, id)) return;
    throw usage_error("--until", "'" + id + "' is not computed by this campaign",
                      expected_name(id, known));
  };
  std::vector<std::string> metrics = options.metrics;
  if (!contains(metrics, "success")) metrics.emplace_back("success");
  expect(rule.metric, metrics);
  if (rule.rows.kind != BinSpec::Kind::All) expect(rule.rows.descriptor, options.descriptors);
  if (rule.rows.kind == BinSpec::Kind::Index)
    throw usage_error("--until", "bins of an index, @" + rule.rows.index,
                      "the edges of its bins, such as density:0,0.1,0.2");
}

/// The columns that a look requires.
std::vector<std::string> ids_of(const PrecisionRule& rule) {
  if (rule.rows.kind == BinSpec::Kind::All) return {rule.metric};
  return {rule.metric, rule.rows.descriptor};
}

/// Keeps only the runs in these scenarios: a file that is continued holds runs of later batches.
void keep_scenarios(ResultTable& table, const std::set<std::string>& hashes) {
  std::vector<std::size_t> kept;
  for (std::size_t run = 0; run < table.size(); ++run)
    if (hashes.count(table.scenario_hashes[table.scenario[run]]) > 0) kept.push_back(run);
  if (kept.size() == table.size()) return;
  for (auto* column : {&table.scenario, &table.method, &table.outcome, &table.repetition}) {
    for (std::size_t i = 0; i < kept.size(); ++i) (*column)[i] = (*column)[kept[i]];
    column->resize(kept.size());
  }
  for (ValueColumn& metric : table.metrics) metric.reorder(kept);
}

/// Whether each bin is open: some method has not reached the required precision.
std::vector<bool> open_bins(const std::vector<PrecisionCell>& cells, std::size_t bins) {
  std::vector<bool> open(bins, false);
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!cells[i].reached) open[i % bins] = true;
  return open;
}

std::string summary_text(const std::vector<PrecisionCell>& cells, const std::string& stop_reason,
                         int looks, std::size_t runs) {
  const auto reached = std::count_if(cells.begin(), cells.end(),
                                     [](const PrecisionCell& cell) { return cell.reached; });
  return std::to_string(reached) + " of " + std::to_string(cells.size()) + " cells reached after " +
         std::to_string(runs) + " runs and " + std::to_string(looks) + " looks: " + stop_reason +
         "\n";
}

}  // namespace

StoppingRule parse_stopping_rule(const std::string& text, std::size_t max_runs,
                                 const CampaignOptions& options) {
  StoppingRule rule{text, parse_precision_rule(text), max_runs};
  check_ids(rule.precision, options);
  return rule;
}

SequentialReport run_until(CampaignRecorder& recorder, const StoppingRule& rule,
                           std::vector<Scenario> scenarios, double confidence,
                           const Execution& execution) {
  PrecisionRule precision = rule.precision;
  ScenarioPool pool(std::move(scenarios), precision, recorder.options(), execution);
  AnalysisOptions analysis;
  analysis.confidence = confidence;

  SequentialReport report;
  report.complete = !execution.is_interrupted();
  std::vector<PrecisionCell> cells;
  std::vector<bool> open(pool.bins().size(), true);
  std::string stop_reason;
  std::set<std::string> taken;
  std::size_t runs = 0;
  int looks = 0;
  while (report.complete && stop_reason.empty()) {
    const std::vector<Scenario> batch = pool.next_batch(open);
    if (batch.empty()) {
      stop_reason = "no more scenarios for the other cells";
      break;
    }
    report.complete = recorder.run(batch, execution);
    if (!report.complete) break;
    for (const Scenario& scenario : batch) taken.insert(scenario.hash());
    ResultTable results = read_results(recorder.file().path(), ids_of(precision));
    keep_scenarios(results, taken);
    runs = results.size();
    cells = precision_cells(results, precision, analysis, ++looks);
    open = open_bins(cells, pool.bins().size());
    report.reached = std::none_of(open.begin(), open.end(), [](bool is_open) { return is_open; });
    if (report.reached) stop_reason = "required precision reached";
    if (stop_reason.empty() && rule.max_runs > 0 && runs >= rule.max_runs)
      stop_reason = "maximum number of runs reached";
  }
  report.text =
      render_precision_text(precision, cells) + summary_text(cells, stop_reason, looks, runs);
  return report;
}

}  // namespace slalom
