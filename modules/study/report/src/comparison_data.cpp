// SPDX-License-Identifier: BSD-3-Clause
#include "report_data.h"

#include <slalom/analysis/cell_json.h>
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/completion.h>
#include <slalom/analysis/method_ranks.h>
#include <slalom/analysis/performance_profile.h>
#include <slalom/analysis/validity.h>

namespace slalom {
namespace {

constexpr const char* kTime = "time_to_goal";

OrderedJson comparison_json(const ResultTable& runs, const PairedComparison& pair) {
  const bool significant = pair.verdict == Verdict::Better || pair.verdict == Verdict::Worse ||
                           pair.verdict == Verdict::Different;
  return {{"a", index_of_method(runs, pair.a)},
          {"b", index_of_method(runs, pair.b)},
          {"metric", pair.column.info.id},
          {"verdict", to_string(pair.verdict)},
          {"significant", significant},
          {"scenarios", pair.scenarios},
          {"difference", number_or_null(pair.difference)},
          {"interval", interval_json(pair.interval)},
          {"p", pair.p},
          {"adjusted_p", pair.adjusted_p},
          {"family", pair.family},
          {"text", verdict_sentence(pair)}};
}

OrderedJson ranks_json(const ResultTable& runs, const MethodRanks& ranks) {
  OrderedJson methods = OrderedJson::array();
  for (std::size_t i = 0; i < ranks.methods.size(); ++i)
    methods.push_back(
        {{"method", index_of_method(runs, ranks.methods[i])}, {"rank", ranks.test.mean_ranks[i]}});
  return {{"metric", ranks.column.info.id},
          {"methods", methods},
          {"groups", ranks.test.groups},
          {"critical_difference", ranks.test.critical_difference},
          {"level", ranks.alpha},
          {"p", ranks.test.p},
          {"p_text", p_text(ranks.test.p)},
          {"scenarios", ranks.test.scenarios},
          {"all_scenarios", ranks.all_scenarios()},
          {"left_out", left_out_text(ranks)}};
}

OrderedJson profiles_json(const ResultTable& runs, const ProfileTable& table) {
  OrderedJson curves = OrderedJson::array();
  for (const PerformanceProfile& profile : table.profiles) {
    OrderedJson points = OrderedJson::array();
    for (const ProfileStep& step : profile.steps) points.push_back({step.ratio, step.fraction});
    curves.push_back({{"method", index_of_method(runs, profile.method)}, {"points", points}});
  }
  return {{"metric", table.column.info.id},
          {"scenarios", table.scenarios},
          {"left_out", table.left_out},
          {"curves", curves}};
}

}  // namespace

OrderedJson comparisons_json(const ResultTable& runs, const std::vector<PairedComparison>& family) {
  OrderedJson json = OrderedJson::array();
  for (const PairedComparison& pair : family) json.push_back(comparison_json(runs, pair));
  return json;
}

OrderedJson completion_json(const ResultTable& runs) {
  OrderedJson json = OrderedJson::array();
  if (find_metric(runs, kTime) == nullptr || find_metric(runs, "success") == nullptr) return json;
  for (const CompletionCurve& curve : build_completion(runs, kTime)) {
    OrderedJson points = OrderedJson::array();
    for (const CurvePoint& point : curve.incidence) points.push_back({point.time, point.value});
    json.push_back({{"method", index_of_method(runs, curve.method)}, {"points", points}});
  }
  return json;
}

OrderedJson ranks_json(const ResultTable& runs, const std::vector<std::string>& metrics,
                       const AnalysisOptions& options) {
  OrderedJson json = OrderedJson::array();
  for (const std::string& metric : metrics)
    add_if_supported(json,
                     [&] { return ranks_json(runs, build_method_ranks(runs, metric, options)); });
  return json;
}

OrderedJson profiles_json(const ResultTable& runs, const std::vector<std::string>& metrics) {
  OrderedJson json = OrderedJson::array();
  if (runs.methods.size() < 2) return json;
  for (const std::string& metric : metrics) {
    if (find_metric(runs, metric)->info().is_rate()) continue;
    add_if_supported(json, [&] { return profiles_json(runs, build_profiles(runs, metric)); });
  }
  return json;
}

OrderedJson validity_json(const ResultTable& runs, const std::vector<std::string>& metrics,
                          const AnalysisOptions& options) {
  OrderedJson json = OrderedJson::array();
  if (metrics.empty()) return json;
  for (const auto& entry : build_validity(runs, metrics, options).validity)
    json.push_back({{"method", index_of_method(runs, entry.method)},
                    {"descriptor", entry.descriptor},
                    {"metric", entry.metric},
                    {"n", entry.correlation.n},
                    {"rho", number_or_null(entry.correlation.rho)},
                    {"interval", interval_json(entry.correlation.interval)}});
  return json;
}

}  // namespace slalom
