// SPDX-License-Identifier: BSD-3-Clause
#include "robustness.h"
#include "scenario_means.h"

#include <slalom/analysis/campaign_settings.h>
#include <slalom/analysis/cross_table.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

/// One file of the sweep with its parameter value.
struct Setting {
  double value = 0;
  const ResultTable* table = nullptr;
  std::size_t index = 0;  ///< in the sweep
};

double parameter_of(const ResultTable& table, const std::string& parameter) {
  const auto text = campaign_setting(table.manifest, parameter);
  double value = 0;
  if (text && parse_number(*text, value)) return value;
  throw usage_error(table.source,
                    text ? "invalid number '" + *text + "' for " + parameter
                         : "its campaign does not set " + parameter,
                    "the key in each campaign's .ini, or the values with --values");
}

void require_same_settings(const ResultTable& first, const ResultTable& other,
                           const std::string& parameter) {
  const auto differences = campaign_differences(first.manifest, other.manifest, {parameter});
  if (differences.empty()) return;
  throw usage_error(other.source,
                    "its campaign differs from " + first.source + " in more than " + parameter +
                        " (" + join(differences, "; ") + ")",
                    "one parameter, or --despite-settings");
}

std::vector<Setting> sorted_settings(const std::vector<ResultTable>& sweep,
                                     const std::string& parameter,
                                     const RobustnessOptions& options) {
  if (sweep.size() < 2) {
    throw usage_error("--robustness", "a sweep of fewer than two result files", "two or more");
  }
  if (!options.values.empty() && options.values.size() != sweep.size()) {
    throw usage_error("--values",
                      format_number(static_cast<double>(options.values.size())) + " values for " +
                          count_text(sweep.size(), "file"),
                      "one value per file");
  }
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    const bool given = !options.values.empty();
    settings.push_back(
        {given ? options.values[i] : parameter_of(sweep[i], parameter), &sweep[i], i});
    if (!options.allow_differences) require_same_settings(sweep[0], sweep[i], parameter);
  }
  std::stable_sort(settings.begin(), settings.end(),
                   [](const Setting& a, const Setting& b) { return a.value < b.value; });
  for (std::size_t i = 1; i < settings.size(); ++i) {
    if (settings[i].value > settings[i - 1].value) continue;
    throw usage_error(settings[i].table->source,
                      parameter + " = " + format_number(settings[i].value) + ", the same as in " +
                          settings[i - 1].table->source,
                      "a different value in each file");
  }
  return settings;
}

std::string side_name(const Setting& setting, const std::string& method,
                      const std::string& parameter) {
  return method + " at " + parameter + " = " + format_number(setting.value);
}

RobustnessPoint point_of(const Setting& setting, const Setting& first, const std::string& method,
                         const std::string& parameter, const std::string& metric,
                         const ComparisonOptions& options) {
  RobustnessPoint point;
  point.parameter = setting.value;
  point.source = setting.table->source;
  point.result = setting.index;
  const std::uint32_t method_index = index_of_method(*setting.table, method);
  for (std::size_t run = 0; run < setting.table->size(); ++run) {
    if (setting.table->method[run] == method_index) point.runs.push_back(run);
  }
  const std::string name = side_name(setting, method, parameter);
  point.cell = make_cell(*setting.table, point.runs, require_metric(*setting.table, metric),
                         options.analysis);
  if (setting.table != first.table) {
    const Side before{first.table, method, side_name(first, method, parameter)};
    point.change = compare_pair(before, {setting.table, method, name}, metric, options);
    if (!point.change->has_partners())
      throw usage_error(name + " against " + before.name, "no common scenario and repetition",
                        "results of the same scenarios");
  }
  return point;
}

void correct_family(RobustnessTable& table) {
  std::vector<PairedComparison> family;
  for (RobustnessCurve& curve : table.curves) {
    for (RobustnessPoint& point : curve.points) {
      if (point.change) family.push_back(*point.change);
    }
  }
  finish_families(family);
  std::size_t next = 0;
  for (RobustnessCurve& curve : table.curves) {
    for (RobustnessPoint& point : curve.points) {
      if (point.change) point.change = family[next++];
    }
  }
}

void add_orders(RobustnessTable& table, const std::vector<Setting>& settings,
                const std::vector<std::string>& metrics, const RobustnessOptions& options) {
  const ResultTable& first = *settings.front().table;
  for (const Column& column : resolve_columns(first, metrics)) {
    if (column.info.direction == Direction::None) continue;
    for (const Setting& setting : settings) {
      if (setting.table == &first) continue;
      const std::string label = join({"order", column.info.id, format_number(setting.value)}, "/");
      table.orders.push_back({column, setting.value,
                              rank_stability(first, *setting.table, column.info.id,
                                             options.comparison.analysis, label)});
    }
  }
}

}  // namespace

RobustnessTable build_robustness(const std::vector<ResultTable>& sweep,
                                 const std::string& parameter,
                                 const std::vector<std::string>& metrics,
                                 const RobustnessOptions& options, const std::string& method) {
  const std::vector<Setting> settings = sorted_settings(sweep, parameter, options);
  RobustnessTable table;
  table.parameter = parameter;
  ComparisonOptions comparison = options.comparison;
  comparison.despite_settings = true;  // the parameter is one
  table.confidence = comparison.analysis.confidence;
  const ResultTable& first = *settings.front().table;
  if (!method.empty()) index_of_method(first, method);
  for (const std::string& metric : metrics) {
    for (const std::string& name : first.methods) {
      RobustnessCurve& curve = table.curves.emplace_back();
      curve.method = name;
      curve.column = resolve_columns(first, {metric})[0];
      for (const Setting& setting : settings) {
        curve.points.push_back(
            point_of(setting, settings.front(), name, parameter, metric, comparison));
      }
    }
  }
  correct_family(table);
  const auto is_hidden = [&](const RobustnessCurve& curve) {
    return !method.empty() && curve.method != method;
  };
  table.curves.erase(std::remove_if(table.curves.begin(), table.curves.end(), is_hidden),
                     table.curves.end());
  if (method.empty() && first.methods.size() > 1) add_orders(table, settings, metrics, options);
  return table;
}

}  // namespace slalom
