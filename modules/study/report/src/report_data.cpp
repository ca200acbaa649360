// SPDX-License-Identifier: BSD-3-Clause
#include "report_data.h"

#include <slalom/analysis/cell_json.h>
#include <slalom/analysis/common_scenarios.h>
#include <slalom/analysis/descriptor_map.h>
#include <slalom/analysis/failure_taxonomy.h>
#include <slalom/analysis/findings.h>
#include <slalom/analysis/paired_comparison.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/io/svg_scene.h>
#include <slalom/results/privileged.h>
#include <slalom/results/repeatability.h>
#include <slalom/statistics/distributions.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace slalom {
namespace {

/// null for an end without a bound.
OrderedJson range_json(const Range& range) {
  return {range.bounded_below() ? OrderedJson(range.low) : OrderedJson(),
          range.bounded_above() ? OrderedJson(range.high) : OrderedJson()};
}

OrderedJson quantity_json(const QuantityInfo& info) {
  return {{"id", info.id},
          {"version", info.version},
          {"name", info.name},
          {"unit", info.unit},
          {"direction", to_string(info.direction)},
          {"kind", to_string(info.kind)},
          {"range", range_json(info.range)}};
}

OrderedJson quantities_json(const std::vector<const ValueColumn*>& columns) {
  OrderedJson json = OrderedJson::array();
  for (const ValueColumn* column : columns) json.push_back(quantity_json(column->info()));
  return json;
}

OrderedJson cells_json(const std::vector<Cell>& cells) {
  OrderedJson json = OrderedJson::array();
  for (const Cell& cell : cells) json.push_back(cell_json(cell));
  return json;
}

/// Makes the fields of report.json.
class ReportBuilder {
 public:
  ReportBuilder(const ReportInput& input, std::vector<RunGroup>& groups)
      : input_(input), runs_(input.runs), options_(input.options), groups_(groups) {
    for (const Column& column : input.summary.columns) {
      if (column.info.direction != Direction::None && !column.wall_clock)
        directed_.push_back(column.info.id);
    }
  }

  OrderedJson columns() const {
    OrderedJson json = OrderedJson::array();
    for (const Column& column : input_.summary.columns) {
      json.push_back(quantity_json(column.info));
      json.back()["rate"] = column.info.is_rate();
      json.back()["wall_clock"] = column.wall_clock;
    }
    return json;
  }

  OrderedJson methods() const {
    OrderedJson json = OrderedJson::array();
    for (std::size_t i = 0; i < runs_.methods.size(); ++i) {
      const std::string& shown = runs_.methods[i];
      json.push_back({{"name", unmarked_name(runs_, shown)}, {"color", method_color(i)}});
      if (json.back()["name"] != shown) json.back()["label"] = shown;
    }
    return json;
  }

  OrderedJson summary() {
    OrderedJson json = OrderedJson::array();
    for (const MethodSummary& entry : input_.summary.methods) {
      const std::uint32_t method = index_of(entry.method);
      std::vector<std::size_t> runs;
      for (std::size_t run = 0; run < runs_.size(); ++run)
        if (runs_.method[run] == method) runs.push_back(run);
      OrderedJson outcomes = OrderedJson::array();
      for (const std::string& outcome : input_.summary.outcomes) {
        const auto found = entry.outcomes.find(outcome);
        outcomes.push_back(found == entry.outcomes.end() ? 0 : found->second);
      }
      json.push_back(
          {{"method", method},
           {"n", entry.n},
           {"outcomes", outcomes},
           {"cells", input_.is_selected() ? OrderedJson::array() : cells_json(entry.cells)},
           {"runs", group("All runs of " + entry.method, std::move(runs))}});
    }
    return json;
  }

  OrderedJson tables() {
    OrderedJson json = OrderedJson::array();
    for (const std::vector<CrossTable>& tables : input_.tables) {
      if (tables.empty()) continue;
      OrderedJson methods = OrderedJson::array();
      for (const CrossTable& table : tables) methods.push_back(table_json(table));
      json.push_back(
          {{"descriptor", quantity_json(tables.front().descriptor)}, {"methods", methods}});
    }
    return json;
  }

  OrderedJson outcome_fractions() {
    OrderedJson json = OrderedJson::array();
    const FailureTaxonomy failures = build_failure_taxonomy(runs_, BinSpec{}, options_.analysis);
    for (const OutcomeGroup& entry : failures.groups) {
      for (const OutcomeFraction& outcome : entry.outcomes) {
        if (outcome.runs.empty()) continue;
        json.push_back({{"method", index_of(entry.method)},
                        {"outcome", outcome.outcome},
                        {"n", outcome.runs.size()},
                        {"fraction", outcome.fraction},
                        {"interval", interval_json(outcome.interval)},
                        {"runs", group(entry.method + ": " + outcome.outcome, outcome.runs)}});
      }
    }
    return json;
  }

  const std::vector<std::string>& directed() const { return directed_; }

  OrderedJson common_scenarios() {
    OrderedJson json = OrderedJson::array();
    for (CommonScenarios& common :
         build_common_scenarios(runs_, options_.columns, options_.analysis)) {
      OrderedJson methods = OrderedJson::array();
      for (std::size_t i = 0; i < common.cells.size(); ++i) {
        methods.push_back({{"method", i}, {"cell", cell_json(common.cells[i])}});
        methods.back()["runs"] =
            group(runs_.methods[i] + ": " + title_of(common), std::move(common.runs[i]));
      }
      json.push_back({{"metric", common.column.info.id},
                      {"title", title_of(common)},
                      {"scenarios", common.scenarios},
                      {"left_out", common.left_out},
                      {"methods", methods}});
    }
    return json;
  }

  /// Maps of the first column over the first two row specifications of different descriptors.
  OrderedJson maps() {
    OrderedJson json = OrderedJson::array();
    std::vector<BinSpec> axes;
    for (const BinSpec& spec : options_.rows) {
      if (spec.kind == BinSpec::Kind::All) continue;
      if (axes.empty() || (axes.size() == 1 && axes[0].descriptor != spec.descriptor))
        axes.push_back(spec);
    }
    if (axes.size() < 2 || options_.columns.empty()) return json;
    for (const std::string& method : runs_.methods)
      add_if_supported(json, [&] {
        return map_json(build_descriptor_map(runs_, method, axes[0], axes[1],
                                             options_.columns.front(), options_.analysis));
      });
    return json;
  }

 private:
  const ReportInput& input_;
  const ResultTable& runs_;
  const ReportOptions& options_;
  std::vector<RunGroup>& groups_;
  std::vector<std::string> directed_;  ///< ids of the columns in which methods can be better

  std::uint32_t index_of(const std::string& method) const { return index_of_method(runs_, method); }

  std::size_t group(const std::string& title, std::vector<std::size_t> runs) {
    groups_.push_back({title, std::move(runs)});
    return groups_.size() - 1;
  }

  OrderedJson table_json(const CrossTable& table) {
    OrderedJson rows = OrderedJson::array(), sentences = OrderedJson::array();
    for (const CrossRow& row : table.rows) {
      const std::string title =
          table.method + ", " + table.descriptor.id + " in " + row.bin.label();
      rows.push_back({{"bin", row.bin.label()},
                      {"low", number_or_null(row.bin.low)},
                      {"high", number_or_null(row.bin.high)},
                      {"high_included", row.bin.closed},
                      {"cells", cells_json(row.cells)},
                      {"runs", group(title, row.runs)}});
    }
    for (const Finding& finding : condensed_findings(table))
      sentences.push_back(
          {{"text", finding.text}, {"difference", finding.verdict == Finding::Verdict::Trend}});
    return {{"method", index_of(table.method)},
            {"rows", rows},
            {"notes", table.notes},
            {"trends", trends_json(table)},
            {"findings", sentences}};
  }

  OrderedJson map_json(const DescriptorMap& map) {
    const auto labels = [](const std::vector<Bin>& bins) {
      OrderedJson json = OrderedJson::array();
      for (const Bin& bin : bins) json.push_back(bin.label());
      return json;
    };
    OrderedJson fields = OrderedJson::array();
    for (std::size_t row = 0; row < map.rows.size(); ++row) {
      OrderedJson line = OrderedJson::array();
      for (std::size_t column = 0; column < map.columns.size(); ++column) {
        const MapField& field = map.fields[row][column];
        line.push_back(cell_json(field.cell));
        line.back()["runs"] =
            group(map.method + ", " + map.row_descriptor.id + " in " + map.rows[row].label() +
                      ", " + map.column_descriptor.id + " in " + map.columns[column].label(),
                  field.runs);
      }
      fields.push_back(line);
    }
    return {{"method", index_of(map.method)},
            {"metric", map.column.info.id},
            {"row_descriptor", map.row_descriptor.id},
            {"column_descriptor", map.column_descriptor.id},
            {"rows", labels(map.rows)},
            {"columns", labels(map.columns)},
            {"fields", fields},
            {"left_out", map.left_out}};
  }
};

void add_statistics(OrderedJson& json, ReportBuilder& make, const ReportInput& input) {
  const ResultTable& runs = input.runs;
  json["overview"] = overview_json(input);
  json["common_scenarios"] = make.common_scenarios();
  json["tables"] = make.tables();
  json["outcome_fractions"] = make.outcome_fractions();
  json["comparisons"] = comparisons_json(runs, input.comparisons);
  json["completion"] = completion_json(runs);
  json["ranks"] = ranks_json(runs, make.directed(), input.options.analysis);
  json["profiles"] = profiles_json(runs, make.directed());
  json["maps"] = make.maps();
  json["validity"] = validity_json(runs, make.directed(), input.options.analysis);
}

OrderedJson repeatability_json(const std::map<std::string, Repeatability>& measured) {
  OrderedJson json = OrderedJson::object();
  for (const auto& [method, found] : measured)
    json[method] = {{"repeated", found.repeated},
                    {"equal", found.equal},
                    {"difference", printable_line(found.difference)}};
  return json;
}

}  // namespace

ReportInput make_report_input(const ResultTable& runs, const ReportOptions& options) {
  AnalysisOptions analysis = options.analysis;
  analysis.run_ids = false;
  ReportInput input{runs, options, build_summary(runs, options.columns, analysis), {}, {}, {}, {}};
  if (input.is_selected()) return input;
  // One call: the trends of all tables are one family of tests.
  std::vector<CrossTable> tables =
      build_cross_tables(runs, options.rows, options.columns, analysis);
  const std::size_t methods = tables.size() / std::max<std::size_t>(options.rows.size(), 1);
  for (std::size_t i = 0; i < options.rows.size(); ++i) {
    const auto first =
        std::make_move_iterator(tables.begin() + static_cast<std::ptrdiff_t>(i * methods));
    input.tables.emplace_back(first, first + static_cast<std::ptrdiff_t>(methods));
  }
  ComparisonOptions comparison;
  comparison.analysis = options.analysis;
  input.comparisons = directed_comparisons(runs, input.summary.columns, comparison);
  std::vector<CrossTable> all;
  for (const auto& group : input.tables) all.insert(all.end(), group.begin(), group.end());
  input.overview = build_overview(runs, all, input.comparisons, options.analysis);
  return input;
}

OrderedJson report_data(const ReportInput& input, std::vector<RunGroup>& groups) {
  const ResultTable& runs = input.runs;
  std::vector<const ValueColumn*> descriptors;
  for (const ValueColumn& column : runs.descriptors) descriptors.push_back(&column);
  ReportBuilder make(input, groups);
  OrderedJson json = {
      {"format", kReportFormat},
      {"slalom", version()},
      {"campaign", campaign_name(runs.manifest)},
      {"confidence", input.options.analysis.confidence},
      {"z", distributions::normal_quantile(0.5 + input.options.analysis.confidence / 2)},
      {"methods", make.methods()},
      {"outcomes", input.summary.outcomes},
      {"columns", make.columns()},
      {"metrics", quantities_json(repeatable_metrics(runs))},
      {"descriptors", quantities_json(descriptors)}};
  if (input.options.planned_runs > 0) json["planned_runs"] = input.options.planned_runs;
  json["selected"] = input.is_selected();
  json["headlines"] = headlines_json(input);
  json["summary"] = make.summary();
  for (const char* key : {"overview", "common_scenarios", "tables", "outcome_fractions",
                          "comparisons", "completion", "ranks", "profiles", "maps", "validity"})
    json[key] = OrderedJson::array();
  if (!input.is_selected()) add_statistics(json, make, input);
  json["clusters"] = clusters_json(input.options.clusters);
  if (!input.summary.footnote.empty()) json["footnote"] = input.summary.footnote;
  if (const auto measured = repeatability_of(runs.manifest); !measured.empty())
    json["repeatability"] = repeatability_json(measured);
  json["notes"] = notes_on_runs(runs);
  json["manifest"] = runs.manifest;
  return json;
}

std::string campaign_name(const Manifest& manifest) {
  const auto found = manifest.find("campaign");
  return found == manifest.end() || found->second.empty() ? "campaign" : found->second;
}

std::vector<const ValueColumn*> repeatable_metrics(const ResultTable& runs) {
  std::vector<const ValueColumn*> metrics;
  for (const ValueColumn& column : runs.metrics)
    if (!column.wall_clock) metrics.push_back(&column);
  return metrics;
}

OrderedJson rounded_json(double number) {
  double short_number = 0;
  if (!parse_number(fmt::format("{:.6g}", number), short_number)) return nullptr;
  return short_number;
}

OrderedJson rounded_json(const ValueColumn& values, std::size_t row) {
  return values.is_na(row) ? OrderedJson(values.reason(row)) : rounded_json(values.number(row));
}

std::string json_text(const OrderedJson& json) {
  return json.dump(-1, ' ', true, OrderedJson::error_handler_t::replace);
}

}  // namespace slalom
