// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/completion.h>
#include <slalom/analysis/scenario_means.h>

#include <limits>
#include <optional>

namespace slalom {
namespace {

constexpr int kReachedGoal = 1, kFailed = 2, kCensored = 0;

/// T = L / (L / T).
std::optional<double> duration(const ResultTable& table, std::size_t run) {
  const ValueColumn* length = find_metric(table, "path_length");
  const ValueColumn* speed = find_metric(table, "mean_speed");
  if (length == nullptr || speed == nullptr) return std::nullopt;
  if (length->is_na(run) || speed->is_na(run) || speed->number(run) <= 0) return std::nullopt;
  return length->number(run) / speed->number(run);
}

/// One minus each value of the curve.
std::vector<CurvePoint> complement(std::vector<CurvePoint> curve) {
  for (CurvePoint& point : curve) point.value = 1 - point.value;
  return curve;
}

}  // namespace

std::vector<CompletionCurve> build_completion(const ResultTable& table, const std::string& time) {
  const ValueColumn& times = require_metric(table, time);
  std::vector<CompletionCurve> curves(table.methods.size());
  std::vector<std::vector<TimedEnd>> competing(curves.size()), censored(curves.size());
  for (std::size_t run = 0; run < table.size(); ++run) {
    const std::uint32_t method = table.method[run];
    const bool reached = !times.is_na(run);
    if (!reached && !is_failure(table.outcomes[table.outcome[run]])) continue;
    ++curves[method].n;
    if (reached) {
      ++curves[method].successes;
      competing[method].push_back({times.number(run), kReachedGoal});
      censored[method].push_back({times.number(run), kReachedGoal});
      continue;
    }
    // A failure of unknown time does not affect the incidence if it comes last.
    const std::optional<double> end = duration(table, run);
    competing[method].push_back({end.value_or(std::numeric_limits<double>::max()), kFailed});
    if (end) censored[method].push_back({*end, kCensored});
    if (!end) ++curves[method].unknown_end;
  }
  for (std::size_t method = 0; method < curves.size(); ++method) {
    curves[method].method = table.methods[method];
    curves[method].incidence = cumulative_incidence(competing[method], kReachedGoal);
    curves[method].kaplan_meier = complement(kaplan_meier(censored[method]));
  }
  return curves;
}

}  // namespace slalom
