// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/descriptor_map.h>
#include <slalom/analysis/failure_taxonomy.h>

#include <map>
#include <memory>

namespace slalom {
namespace {

OutcomeFraction outcome_fraction(const ResultTable& table, const std::vector<std::size_t>& group,
                                 const std::string& outcome, double confidence) {
  OutcomeFraction result;
  result.outcome = outcome;
  std::map<std::uint32_t, std::pair<double, double>> by_scenario;
  for (const std::size_t run : group) {
    const bool matches = table.outcomes[table.outcome[run]] == outcome;
    if (matches) result.runs.push_back(run);
    by_scenario[table.scenario[run]].first += matches ? 1 : 0;
    by_scenario[table.scenario[run]].second += 1;
  }
  if (group.empty()) return result;
  GroupSums sums;
  for (const auto& [scenario, counts] : by_scenario) {
    sums.sums.push_back(counts.first);
    sums.sizes.push_back(counts.second);
  }
  result.fraction = static_cast<double>(result.runs.size()) / static_cast<double>(group.size());
  result.interval = rate_interval(moments_of(sums), confidence);
  return result;
}

}  // namespace

FailureTaxonomy build_failure_taxonomy(const ResultTable& table, const BinSpec& spec,
                                       const AnalysisOptions& options, const std::string& method) {
  require_valid(options);
  const std::size_t only = method.empty() ? table.methods.size() : index_of_method(table, method);
  FailureTaxonomy taxonomy;
  taxonomy.confidence = options.confidence;
  taxonomy.outcomes = table.outcomes;
  taxonomy.descriptor = {"all", 1, "All scenarios", "-", Direction::None};
  const std::vector<Bin> bins = make_bins(spec, table);
  std::unique_ptr<RunValues> values;
  if (spec.kind != BinSpec::Kind::All) {
    values = std::make_unique<RunValues>(table, spec.descriptor);
    taxonomy.descriptor = values->info();
  }
  std::vector<std::vector<std::vector<std::size_t>>> runs(
      table.methods.size(), std::vector<std::vector<std::size_t>>(bins.size()));
  const auto is_filtered_out = [&](std::size_t index) {
    return only != table.methods.size() && only != index;
  };
  for (std::size_t run = 0; run < table.size(); ++run) {
    if (is_filtered_out(table.method[run])) continue;
    const bool described = !values || !values->is_na(run);
    const std::size_t bin = described ? bin_of(bins, values ? (*values)(run) : 0) : bins.size();
    if (bin == bins.size()) {
      ++taxonomy.left_out;
    } else {
      runs[table.method[run]][bin].push_back(run);
    }
  }
  for (std::size_t index = 0; index < runs.size(); ++index) {
    if (is_filtered_out(index)) continue;
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
      const std::vector<std::size_t>& group = runs[index][bin];
      OutcomeGroup& row = taxonomy.groups.emplace_back(
          OutcomeGroup{table.methods[index], bins[bin], group.size(), {}});
      for (const std::string& outcome : taxonomy.outcomes) {
        row.outcomes.push_back(outcome_fraction(table, group, outcome, options.confidence));
      }
    }
  }
  return taxonomy;
}

}  // namespace slalom
