// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/survival.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// The events at one time.
struct EventTime {
  double time = 0;
  double at_risk = 0;
  double events = 0;       ///< of the cause of interest
  double competitors = 0;  ///< of other causes
};

std::vector<EventTime> event_times(std::vector<TimedEnd>& ends, int cause) {
  std::sort(ends.begin(), ends.end(),
            [](const TimedEnd& a, const TimedEnd& b) { return a.time < b.time; });
  std::vector<EventTime> result;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (result.empty() || ends[i].time > result.back().time) {
      result.push_back({ends[i].time, static_cast<double>(ends.size() - i), 0, 0});
    }
    if (ends[i].cause == cause) result.back().events += 1;
    if (ends[i].cause != cause && ends[i].cause != 0) result.back().competitors += 1;
  }
  return result;
}

CurvePoint point_at(const EventTime& event, double value, double variance) {
  return {event.time, static_cast<std::size_t>(event.at_risk), value,
          std::sqrt(std::max(0.0, variance))};
}

/// Sums over the event times so far for the variance of an incidence: I is the incidence at each, S
/// the fraction without an end before it, d the number of all ends, e of those by the cause.
struct IncidenceVariance {
  double a = 0, ai = 0, aii = 0;  ///< of d / (n (n - d)), times 1, I, I^2
  double b = 0;                   ///< of S^2 (n - e) / n e / n^2
  double c = 0, ci = 0;           ///< of S e / n^2, times 1, I

  void add(const EventTime& m, double survival, double incidence) {
    const double n = m.at_risk, ended = m.events + m.competitors;
    if (n > ended) {
      const double term = ended / (n * (n - ended));
      a += term;
      ai += term * incidence;
      aii += term * incidence * incidence;
    }
    b += survival * survival * (n - m.events) / n * m.events / (n * n);
    c += survival * m.events / (n * n);
    ci += survival * m.events / (n * n) * incidence;
  }
  /// The variance at the current incidence.
  double variance(double incidence) const {
    return a * incidence * incidence - 2 * incidence * ai + aii + b - 2 * (incidence * c - ci);
  }
};

}  // namespace

std::vector<CurvePoint> kaplan_meier(std::vector<TimedEnd> ends) {
  std::vector<CurvePoint> curve;
  double survival = 1, greenwood = 0;
  for (const EventTime& m : event_times(ends, 1)) {
    if (m.events == 0) continue;
    survival *= (m.at_risk - m.events) / m.at_risk;
    if (m.at_risk > m.events) greenwood += m.events / (m.at_risk * (m.at_risk - m.events));
    curve.push_back(point_at(m, survival, survival * survival * greenwood));
  }
  return curve;
}

std::vector<CurvePoint> cumulative_incidence(std::vector<TimedEnd> ends, int cause) {
  std::vector<CurvePoint> curve;
  double survival = 1, incidence = 0;
  IncidenceVariance sums;
  for (const EventTime& m : event_times(ends, cause)) {
    if (m.events + m.competitors == 0) continue;
    incidence += survival * m.events / m.at_risk;
    sums.add(m, survival, incidence);
    survival *= (m.at_risk - m.events - m.competitors) / m.at_risk;
    if (m.events > 0) curve.push_back(point_at(m, incidence, sums.variance(incidence)));
  }
  return curve;
}

std::optional<Interval> log_log_interval(double fraction, double standard_error,
                                         double confidence) {
  if (fraction <= 0 || fraction >= 1) return std::nullopt;
  const double z = distributions::normal_quantile(0.5 + confidence / 2);
  const double spread = z * standard_error / (fraction * std::abs(math::log(fraction)));
  const double lower = math::pow(fraction, math::exp(spread)),
               upper = math::pow(fraction, math::exp(-spread));
  return Interval{lower, upper};
}

}  // namespace slalom
