// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/analysis_request.h>
#include <slalom/analysis/analysis_section.h>
#include <slalom/analysis/csv_columns.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>
#include <slalom/results/recorded_ini.h>

namespace slalom {
namespace {

AnalysisSection analysis_defaults(const Manifest& manifest) {
  return read_options<AnalysisSection>(recorded_ini(manifest, "campaign.ini"), "analysis");
}

std::vector<BinSpec> rows_of(const AnalysisRequest& request, const AnalysisSection& defaults,
                             const ResultTable& results) {
  if (!request.rows.empty()) return parse_bin_specs(request.rows, "--rows");
  if (!defaults.rows.empty()) return parse_bin_specs(defaults.rows);
  return parse_bin_specs(find_descriptor(results, "density") != nullptr ? "density:q4" : "all");
}

/// Each once: a metric that is named twice does not enlarge a family of tests.
std::vector<std::string> distinct_ids(const std::string& text) {
  std::vector<std::string> ids;
  for (std::string& id : split_nonempty(text, ','))
    if (!contains(ids, id)) ids.push_back(std::move(id));
  return ids;
}

/// The only column whose name is that of a time.
std::string time_column(const ResultTable& results) {
  std::vector<std::string> ids;
  for (const ValueColumn& column : results.metrics)
    if (!column.wall_clock && is_time_name(column.info().id)) ids.push_back(column.info().id);
  if (ids.size() == 1) return ids[0];
  throw usage_error("completion",
                    ids.empty() ? results.source + " has no column that is called a time"
                                : join(ids, ", ") + " may all be the time",
                    "--metric COLUMN of times");
}

std::vector<std::string> metrics_of(const AnalysisRequest& request, const AnalysisSection& defaults,
                                    const Interpreter& interpreter, const ResultTable& results) {
  if (!request.metrics.empty()) return distinct_ids(request.metrics);
  if (!request.gates.empty()) return {};
  const bool tables = interpreter.id == "table" || interpreter.id == "summary";
  if (tables && !defaults.columns.empty()) return distinct_ids(defaults.columns);
  std::vector<std::string> metrics;
  for (const std::string& id : interpreter.default_metrics) {
    if (find_metric(results, id) != nullptr) metrics.push_back(id);
  }
  if (metrics.empty() && interpreter.id == "completion") metrics.push_back(time_column(results));
  if (metrics.empty()) metrics.push_back(results.metrics.front().info().id);
  return metrics;
}

std::vector<double> values_of(const std::string& text) {
  std::vector<double> values;
  for (const std::string& part : split_nonempty(text, ',')) {
    if (!parse_number(part, values.emplace_back())) {
      throw usage_error("--values", "invalid number '" + part + "'", "comma-separated numbers");
    }
  }
  return values;
}

}  // namespace

void require_number_of_results(const Interpreter& interpreter, std::size_t results) {
  const std::size_t min = interpreter.min_results, max = interpreter.max_results;
  if (results >= min && results <= max) return;
  const std::string range =
      max > 100 ? std::to_string(min) + " result files or more"
                : std::to_string(min) + " or " + std::to_string(max) + " result files";
  const bool is_option = interpreter.verb != interpreter.id;
  throw usage_error((is_option ? "--" : "") + interpreter.id, count_text(results, "file"),
                    max == 1 ? "one result file" : range);
}

std::optional<std::vector<std::string>> requested_columns(const AnalysisRequest& request,
                                                          const Interpreter& interpreter) {
  if (request.rows.empty() || interpreter.needs_descriptors) return std::nullopt;
  if (request.metrics.empty() && request.gates.empty()) return std::nullopt;
  std::vector<std::string> ids = split_nonempty(request.metrics, ',');
  for (const std::string& gate : request.gates) ids.push_back(parse_gate(gate).metric);
  for (const std::string& id : interpreter.additional_metrics) ids.push_back(id);
  for (const BinSpec& spec : parse_bin_specs(request.rows, "--rows")) {
    if (spec.kind != BinSpec::Kind::All) ids.push_back(spec.descriptor);
  }
  return ids;
}

AnalysisQuery make_query(const AnalysisRequest& request, const Interpreter& interpreter,
                         const ResultTable& results) {
  const AnalysisSection defaults = analysis_defaults(results.manifest);
  AnalysisQuery query;
  query.rows = rows_of(request, defaults, results);
  query.metrics = metrics_of(request, defaults, interpreter, results);
  query.method = request.method;
  query.baseline = request.baseline;
  query.parameter = request.parameter;
  query.values = values_of(request.values);
  query.comparison.despite_settings = request.despite_settings;
  for (const std::string& gate : request.gates) query.gates.push_back(parse_gate(gate));
  query.gate_on = request.gate_on;
  query.comparison.analysis.confidence =
      request.confidence > 0 ? request.confidence : defaults.confidence;
  if (request.relevant > 0) query.comparison.relevant = request.relevant;
  query.comparison.power = request.power;
  return query;
}

}  // namespace slalom
