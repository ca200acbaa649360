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

/// The mean of both, weighted by the inverse squares of their standard errors.
Value pooled(const Value& a, const Value& b) {
  const double weight_a = std::pow(*a.standard_error(), -2);
  const double weight_b = std::pow(*b.standard_error(), -2);
  const double sum = weight_a + weight_b;
  return Value::of((weight_a * a.number() + weight_b * b.number()) / sum, 1 / std::sqrt(sum));
}

/// The delay or the time constant from the fits of v and w.
Estimate pool(const std::string& id, const ResponseFit& v, const ResponseFit& w,
              Value ResponseFit::*member, std::vector<std::string>& warnings) {
  if (!v.problem.empty() && !w.problem.empty())
    return {id, "s",
            Value::na(v.problem == w.problem ? v.problem : "v: " + v.problem + "; w: " + w.problem),
            0};
  if (!v.problem.empty()) return {id, "s", w.*member, w.samples};
  if (!w.problem.empty()) return {id, "s", v.*member, v.samples};
  const Value &a = v.*member, &b = w.*member;
  constexpr double kErrors = 3;
  const double error = std::hypot(*a.standard_error(), *b.standard_error());
  if (std::abs(a.number() - b.number()) > kErrors * error)
    warnings.push_back(id + " differs between v (" + format_fixed(a.number(), 4) + " s) and w (" +
                       format_fixed(b.number(), 4) + " s) by more than 3 standard errors");
  return {id, "s", pooled(a, b), v.samples + w.samples};
}

Estimate bias(const std::string& id, const ResponseFit& fit) {
  return {id, "-", fit.problem.empty() ? fit.gain : Value::na(fit.problem), fit.samples};
}

void add_noise(const MotionLog& log, std::vector<Estimate>& estimates) {
  RangeNoise noise;
  if (log.scans.empty())
    noise.problem =
        log.labels.scan.empty() ? "no 2D scans" : "no 2D scans labeled '" + log.labels.scan + "'";
  else if (log.odometry.empty())
    noise.problem = missing_label(log, log.labels.odometry);
  else
    noise = estimate_range_noise(log);
  const auto add = [&](const std::string& id, const std::string& unit, const Value& value) {
    estimates.push_back(
        {id, unit, noise.problem.empty() ? value : Value::na(noise.problem), noise.ranges});
  };
  add("noise_sigma", "m", noise.sigma);
  add("dropout_ratio", "-", noise.dropout_ratio);
  add("quantum", "m", Value::of(noise.quantum));
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
