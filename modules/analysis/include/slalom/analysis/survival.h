#pragma once

#include <slalom/analysis/statistics.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// How one run came to its end, for curves over time.
struct TimedEnd {
  double time = 0;  ///< s, not negative
  int cause = 0;    ///< 0: observed no further (censored); 1, 2, ...: what ended it
};

/// A step of a curve: its value from `time` on, until the next step.
struct CurvePoint {
  double time = 0;
  std::size_t at_risk = 0;  ///< runs that had not ended before
  double value = 0;
  double standard_error = 0;
};

/// Kaplan and Meier's (1958) estimate of the share that has not ended by `cause` 1 yet, with
/// Greenwood's standard error; all other causes count as censored. One point a time at which
/// something ended by that cause.
std::vector<CurvePoint> kaplan_meier(std::vector<TimedEnd> ends);

/// Aalen and Johansen's (1978) estimate of the share that has ended by `cause`, where the other
/// causes compete with it: what ended otherwise can no longer end so. Standard error: the delta
/// method (Marubini and Valsecchi 1995). Without censored ends the value is the plain share.
std::vector<CurvePoint> cumulative_incidence(std::vector<TimedEnd> ends, int cause);

/// An interval of a share with that standard error, on the scale log(-log), which keeps it within
/// (0, 1) (Kalbfleisch and Prentice). None where the share is 0 or 1.
std::optional<Interval> share_interval(double share, double standard_error, double confidence);

}  // namespace slalom
