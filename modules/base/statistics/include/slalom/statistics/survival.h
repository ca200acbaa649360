// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/statistics.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// The end of one run, for curves over time.
struct TimedEnd {
  double time = 0;  ///< s, not negative
  int cause = 0;    ///< 0: censored; 1, 2, ...: cause
};

/// A step of a curve: its value from `time` until the next step.
struct CurvePoint {
  double time = 0;
  std::size_t at_risk = 0;  ///< runs that have not ended before
  double value = 0;
  double standard_error = 0;
};

/// Kaplan-Meier estimate (1958) of the fraction that has not ended by `cause` 1, with Greenwood's
/// standard error; other causes count as censored. One point per event time of that cause.
std::vector<CurvePoint> kaplan_meier(std::vector<TimedEnd> ends);

/// Aalen-Johansen estimate (1978) of the fraction that has ended by `cause`, with the other causes
/// as competing risks. Standard error: delta method (Marubini and Valsecchi 1995). Without
/// censoring the value is the empirical fraction.
std::vector<CurvePoint> cumulative_incidence(std::vector<TimedEnd> ends, int cause);

/// Confidence interval of a fraction on the log(-log) scale, which stays within (0, 1) (Kalbfleisch
/// and Prentice). None if the fraction is 0 or 1.
std::optional<Interval> log_log_interval(double fraction, double standard_error, double confidence);

}  // namespace slalom
