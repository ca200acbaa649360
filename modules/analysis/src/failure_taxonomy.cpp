#include <slalom/analysis/descriptor_map.h>
#include <slalom/analysis/failure_taxonomy.h>

#include <memory>
#include <set>

namespace slalom {
namespace {

std::vector<std::string> ordered_outcomes(const RunColumns& table) {
  std::set<std::string> names(table.outcomes.begin(), table.outcomes.end());
  std::vector<std::string> ordered;
  if (names.erase("success") > 0) ordered.emplace_back("success");
  ordered.insert(ordered.end(), names.begin(), names.end());
  return ordered;
}

OutcomeShare outcome_share(const RunColumns& table, const std::vector<std::size_t>& group,
                           const std::string& outcome, double confidence) {
  OutcomeShare result;
  result.outcome = outcome;
  std::map<std::uint32_t, std::pair<double, double>> by_scenario;
  for (const std::size_t run : group) {
    const bool so = table.outcomes[table.outcome[run]] == outcome;
    if (so) result.runs.push_back(run);
    by_scenario[table.scenario[run]].first += so ? 1 : 0;
    by_scenario[table.scenario[run]].second += 1;
  }
  if (group.empty()) return result;
  GroupSums sums;
  for (const auto& [scenario, counts] : by_scenario) {
    sums.sums.push_back(counts.first);
    sums.sizes.push_back(counts.second);
  }
  result.share = static_cast<double>(result.runs.size()) / static_cast<double>(group.size());
  result.interval = wilson_interval(result.share, effective_sample_size(sums), confidence);
  return result;
}

}  // namespace

FailureTaxonomy build_failure_taxonomy(const RunColumns& table, const BinSpec& spec,
                                       const AnalysisOptions& options) {
  require_valid(options);
  FailureTaxonomy taxonomy;
  taxonomy.confidence = options.confidence;
  taxonomy.outcomes = ordered_outcomes(table);
  taxonomy.descriptor = {"all", 1, "All scenarios", "-", Direction::None};
  const std::vector<Bin> bins = make_bins(spec, table);
  std::unique_ptr<RunValues> values;
  if (spec.kind != BinSpec::Kind::All) {
    values = std::make_unique<RunValues>(table, spec.descriptor);
    taxonomy.descriptor = values->info();
  }
  std::vector<std::vector<std::vector<std::size_t>>> runs(
      table.methods.size(), std::vector<std::vector<std::size_t>>(bins.size()));
  for (std::size_t run = 0; run < table.size(); ++run) {
    const bool described = !values || !values->is_na(run);
    const std::size_t bin = described ? bin_of(bins, values ? (*values)(run) : 0) : bins.size();
    if (bin == bins.size()) {
      ++taxonomy.left_out;
    } else {
      runs[table.method[run]][bin].push_back(run);
    }
  }
  for (std::size_t method = 0; method < runs.size(); ++method) {
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
      const std::vector<std::size_t>& group = runs[method][bin];
      OutcomeGroup& row = taxonomy.groups.emplace_back(
          OutcomeGroup{table.methods[method], bins[bin], group.size(), {}});
      for (const std::string& outcome : taxonomy.outcomes) {
        row.outcomes.push_back(outcome_share(table, group, outcome, options.confidence));
      }
    }
  }
  return taxonomy;
}

}  // namespace slalom
