// SPDX-License-Identifier: BSD-3-Clause
#include "profile.h"
#include "range_noise.h"
#include "response_fit.h"

#include <slalom/core/text.h>
#include <slalom/rawlog/identification.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace slalom {
namespace {

std::string missing_label(const MotionLog& log, const std::string& label) {
  return "no velocities labeled '" + label + "'" +
         (log.odometry_labels.empty()
              ? "; the log has no odometry"
              : "; the log has '" + join(log.odometry_labels, "', '") + "'");
}

ResponseFit fit_velocity(const MotionLog& log, double LoggedVelocity::*velocity, double lowest,
                         double highest, double max_acceleration, double max_delay) {
  ResponseFit missing;
  if (log.commands.empty())
    missing.problem = missing_label(log, log.labels.command);
  else if (log.odometry.empty())
    missing.problem = missing_label(log, log.labels.odometry);
  if (!missing.problem.empty()) return missing;
  ResponseData data;
  for (const LoggedVelocity& command : log.commands) {
    data.command_times.push_back(command.time);
    data.commands.push_back(std::clamp(command.*velocity, lowest, highest));
  }
  for (const LoggedVelocity& measured : log.odometry) {
    data.times.push_back(measured.time);
    data.measured.push_back(measured.*velocity);
  }
  data.max_acceleration = max_acceleration;
  return fit_response(data, max_delay);
}

/// An interval that ends at the greatest value considered would be too short.
Estimate profiled(const std::string& id, const std::string& unit, const Profile& profile,
                  std::size_t samples) {
  const Interval interval = profile_interval(profile, Identification::kConfidence);
  if (!(interval.high < profile.highest))
    return {id, unit,
            Value::na("all values from " + format_fixed(interval.low, 4) + " to " +
                      format_number(profile.highest) + " " + unit + " are as likely"),
            samples};
  return {id, unit, Value::of(profile.best), samples, interval};
}

/// The delay or the time constant from the fits of v and w.
Estimate pool(const std::string& id, const ResponseFit& v, const ResponseFit& w,
              Profile ResponseFit::*member, std::vector<std::string>& warnings) {
  if (!v.problem.empty() && !w.problem.empty())
    return {id, "s",
            Value::na(v.problem == w.problem ? v.problem : "v: " + v.problem + "; w: " + w.problem),
            0};
  if (!v.problem.empty()) return profiled(id, "s", w.*member, w.samples);
  if (!w.problem.empty()) return profiled(id, "s", v.*member, v.samples);
  const Profile &a = v.*member, &b = w.*member, both = pooled(a, b);
  Estimate estimate = profiled(id, "s", both, v.samples + w.samples);
  constexpr double kErrors = 3;
  if (both.deviance(both.best) > kErrors * kErrors) {
    warnings.push_back(id + " differs between v (" + format_fixed(a.best, 4) + " s) and w (" +
                       format_fixed(b.best, 4) + " s) by more than 3 standard errors");
    const Interval of_a = profile_interval(a, Identification::kConfidence);
    const Interval of_b = profile_interval(b, Identification::kConfidence);
    estimate.interval = {std::min(of_a.low, of_b.low), std::max(of_a.high, of_b.high)};
  }
  return estimate;
}

Estimate bias(const std::string& id, const ResponseFit& fit) {
  if (!fit.problem.empty()) return {id, "-", Value::na(fit.problem), fit.samples};
  return profiled(id, "-", fit.gain, fit.samples);
}

void add_noise(const MotionLog& log, std::vector<Estimate>& estimates) {
  RangeNoise noise;
  if (log.scans.empty())
    noise.problem =
        log.labels.scan.empty() ? "no 2D scans" : "no 2D scans labeled '" + log.labels.scan + "'";
  else if (log.odometry.empty())
    noise.problem = missing_label(log, log.labels.odometry);
  else
    noise = estimate_range_noise(log, Identification::kConfidence);
  const auto add = [&](Estimate estimate) {
    estimate.samples = noise.ranges;
    if (!noise.problem.empty()) estimate.value = Value::na(noise.problem);
    estimates.push_back(estimate);
  };
  add({"noise_sigma", "m", Value::of(noise.sigma), 0, noise.sigma_interval});
  add({"dropout_ratio", "-", Value::of(noise.dropout_ratio), 0, noise.dropout_interval});
  add({"quantum", "m", Value::of(noise.quantum), 0, {}, "a common divisor, not a mean"});
}

}  // namespace

const Estimate& Identification::at(const std::string& id) const {
  for (const Estimate& estimate : estimates)
    if (estimate.id == id) return estimate;
  throw std::out_of_range("Identification: no estimate " + id);
}

Identification identify(const MotionLog& log, const IdentificationSetup& setup) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  RobotModel robot;
  robot.forward_only = false;
  robot.max_v = robot.max_w = kAny;
  robot.max_accel_v = robot.max_accel_w = 0;  // unknown
  robot = setup.robot.value_or(robot);
  const ResponseFit v = fit_velocity(log, &LoggedVelocity::v, robot.forward_only ? 0 : -robot.max_v,
                                     robot.max_v, robot.max_accel_v, setup.max_delay);
  const ResponseFit w = fit_velocity(log, &LoggedVelocity::w, -robot.max_w, robot.max_w,
                                     robot.max_accel_w, setup.max_delay);
  Identification result;
  result.estimates = {pool("delay", v, w, &ResponseFit::delay, result.warnings),
                      pool("delay_tau", v, w, &ResponseFit::delay_tau, result.warnings),
                      bias("v_bias", v), bias("w_bias", w)};
  add_noise(log, result.estimates);
  return result;
}

}  // namespace slalom
