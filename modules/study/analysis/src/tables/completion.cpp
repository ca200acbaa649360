// SPDX-License-Identifier: BSD-3-Clause
#include "../comparison/scenario_means.h"

#include <slalom/analysis/completion.h>
#include <slalom/core/error.h>

#include <limits>
#include <optional>

namespace slalom {
namespace {

constexpr int kReachedGoal = 1, kFailed = 2, kCensored = 0;

/// The time of a failure, as the table has it or T = L / (L / T).
std::optional<double> duration(const ResultTable& table, const ValueColumn& times,
                               std::size_t run) {
  if (&times != find_metric(table, times.info().id) && !times.is_na(run)) return times.number(run);
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

void require_times(const ResultTable& table, const ValueColumn& times) {
  if (find_metric(table, "success") == nullptr)
    throw usage_error("completion", table.source + " has neither outcomes nor success",
                      "a column success or outcome, or --outcome-column NAME");
  if (times.info().is_rate())
    throw usage_error("completion", "'" + times.info().id + "' is a rate",
                      "--metric COLUMN of times");
}

}  // namespace

std::vector<CompletionCurve> build_completion(const ResultTable& table, const std::string& time) {
  const ValueColumn& times = require_metric(table, time);
  const ValueColumn& ends = *find_unconditional(table, time);
  require_times(table, times);
  std::vector<CompletionCurve> curves(table.methods.size());
  std::vector<std::vector<TimedEnd>> competing(curves.size()), censored(curves.size());
  for (std::size_t run = 0; run < table.size(); ++run) {
    const std::uint32_t method = table.method[run];
    const std::string& outcome = table.outcomes[table.outcome[run]];
    const bool reached = outcome == "success";
    if (!reached && !is_failure(outcome)) continue;
    if (reached && times.is_na(run)) {
      ++curves[method].untimed;
      continue;
    }
    ++curves[method].n;
    if (reached) {
      ++curves[method].successes;
      competing[method].push_back({times.number(run), kReachedGoal});
      censored[method].push_back({times.number(run), kReachedGoal});
      continue;
    }
    // A failure of unknown time does not affect the incidence if it comes last.
    const std::optional<double> end = duration(table, ends, run);
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
