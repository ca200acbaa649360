#include "delayed_response.h"
#include "lag_fit.h"
#include "response_fit.h"

#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

constexpr double kMaxTau = 5;  // s
constexpr std::size_t kMinVelocities = 20;

/// The delay and the time constant, s.
struct Lag {
  double delay = 0, tau = 0;
};

class ResponseFitter {
 public:
  ResponseFitter(const ResponseData& data, double max_delay)
      : data_(data), max_delay_(max_delay), limited_(data.times.size()) {}

  ResponseFit fit() {
    const auto residual_of = [this](const Lag& lag) { return evaluate(lag).residual; };
    const Lag stride = {max_delay_ / kGridDelays, 0.05};
    Lag lag = search(best_of_grid(residual_of), stride, residual_of);
    const double gain = evaluate(lag).gain;
    if (!(gain > 0)) return estimate(lag);
    start_ = data_.measured.front() / gain;
    const double limit = find_limit(lag, greatest_acceleration() / gain);
    if (std::isfinite(limit)) {
      mark_limited(lag, limit);
      lag = search(lag, {0.01, 0.01}, residual_of);
    }
    return estimate(lag);
  }

 private:
  static constexpr int kGridDelays = 40;

  /// The greatest acceleration, over at least 0.1 s, since noise dominates that of shorter times.
  double greatest_acceleration() const {
    constexpr double kBase = 0.1;
    const auto& t = data_.times;
    double greatest = 0;
    for (std::size_t k = 0, end = 1; end < t.size(); ++k) {
      while (end < t.size() && t[end] - t[k] < kBase - kSameTime) ++end;
      if (end < t.size())
        greatest =
            std::max(greatest, std::abs(data_.measured[end] - data_.measured[k]) / (t[end] - t[k]));
    }
    return greatest;
  }

  /// Least squares of the response to all commands, with the acceleration limited in proportion to
  /// the gain.
  LagFit simulate_limited(const Lag& lag, double limit) const {
    double mm = 0, rm = 0, rr = 0;
    DelayedCommands commands(data_, lag.delay);
    double response = start_;
    for (std::size_t k = 1; k < data_.times.size(); ++k) {
      commands.advance(data_.times[k - 1], data_.times[k], [&](double command, double duration) {
        response = respond(response, command, lag.tau, duration, limit);
      });
      mm += data_.measured[k] * data_.measured[k];
      rm += response * data_.measured[k];
      rr += response * response;
    }
    LagFit fit;
    fit.samples = data_.times.size();
    if (rr > 0) fit.gain = rm / rr;
    fit.residual = mm - fit.gain * rm;
    return fit;
  }

  /// The limit of acceleration: that which is given, or with which the log is most likely; infinity
  /// unless it is much more likely than without. At most `greatest` if it is not given. Updates
  /// `lag` to that with the limit.
  double find_limit(Lag& lag, double greatest) const {
    constexpr double kRatio = 0.93, kMuchMoreLikely = 20;  // twice the logarithm of the likelihoods
    const bool is_given = data_.max_acceleration > 0;
    const int candidates = is_given ? 1 : 20;
    const auto deviance = [](const LagFit& fit) {
      return static_cast<double>(fit.samples) * std::log(fit.variance());
    };
    // A limit that is active for less than the time between two velocities exceeds all measured.
    constexpr double kExcess = 1.5;
    double limit = is_given ? data_.max_acceleration : kExcess * greatest;
    double least = deviance(simulate_limited(lag, kNoLimit)) - kMuchMoreLikely;
    if (is_given) least = std::numeric_limits<double>::infinity();
    double found = kNoLimit;
    Lag limited = lag;
    for (int i = 0; i < candidates; ++i, limit *= kRatio) {
      const auto residual_of = [&](const Lag& candidate) {
        return simulate_limited(candidate, limit).residual;
      };
      limited = search(limited, {max_delay_ / kGridDelays, 0.05}, residual_of);
      const double now = deviance(simulate_limited(limited, limit));
      if (now >= least) continue;
      least = now;
      lag = limited;
      found = limit;
    }
    return found;
  }

  /// Marks the intervals at whose end the limit changes the velocity. It is simulated, since a
  /// choice by measured velocities would depend on their noise.
  void mark_limited(const Lag& lag, double limit) {
    constexpr double kMargin = 0.9;  // a limit that is too high is worse than one that is too low
    const auto [low, high] = std::minmax_element(data_.commands.begin(), data_.commands.end());
    const double tolerance = 0.001 * (*high - *low);
    DelayedCommands commands(data_, lag.delay);
    double velocity = start_;
    for (std::size_t k = 1; k < limited_.size(); ++k) {
      double free = velocity, limited = velocity;
      commands.advance(data_.times[k - 1], data_.times[k], [&](double command, double duration) {
        free = respond(free, command, lag.tau, duration);
        limited = respond(limited, command, lag.tau, duration, kMargin * limit);
        velocity = respond(velocity, command, lag.tau, duration, limit);
      });
      if (std::abs(limited - free) > tolerance) limited_[k] = 1;
    }
  }

  LagFit evaluate(const Lag& lag) const {
    LagFit fit;
    double forced_measured = 0, decay = 1, forced = 0;
    SegmentSums segment;
    segment.add(decay, forced, data_.measured[0]);
    DelayedCommands commands(data_, lag.delay);
    for (std::size_t k = 1; k < data_.times.size(); ++k) {
      commands.advance(data_.times[k - 1], data_.times[k], [&](double command, double duration) {
        forced = respond(forced, command, lag.tau, duration);
        decay = respond(decay, 0, lag.tau, duration);
      });
      if (limited_[k] != 0) {
        segment.add_to(fit, forced_measured);
        segment = {};
        decay = 1;
        forced = 0;
      }
      segment.add(decay, forced, data_.measured[k]);
    }
    segment.add_to(fit, forced_measured);
    if (fit.information > 0) fit.gain = forced_measured / fit.information;
    fit.residual = std::max(0.0, fit.residual - fit.gain * forced_measured);
    return fit;
  }

  template <typename Residual>
  Lag best_of_grid(Residual residual_of) const {
    std::vector<double> taus = {0};
    for (double tau = 0.01; tau < kMaxTau; tau *= 1.3) taus.push_back(tau);
    Lag best;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kGridDelays; ++i)
      for (const double tau : taus) {
        const Lag lag = {i * max_delay_ / kGridDelays, tau};
        const double residual = residual_of(lag);
        if (residual < least) {
          least = residual;
          best = lag;
        }
      }
    return best;
  }

  /// Pattern search: moves to the best neighbor, or halves the strides if there is no better one. A
  /// stride of 0 keeps that parameter.
  template <typename Residual>
  Lag search(Lag best, Lag stride, Residual residual_of) const {
    constexpr double kMinStride = 1e-5;  // s
    double least = residual_of(best);
    while (std::max(stride.delay, stride.tau) > kMinStride) {
      Lag neighbor = best;
      for (const double i : {-1, 0, 1})
        for (const double j : {-1, 0, 1}) {
          if ((i != 0 && stride.delay == 0) || (j != 0 && stride.tau == 0)) continue;
          const Lag lag = {std::clamp(best.delay + i * stride.delay, 0.0, max_delay_),
                           std::clamp(best.tau + j * stride.tau, 0.0, kMaxTau)};
          const double residual = residual_of(lag);
          if (residual < least) {
            least = residual;
            neighbor = lag;
          }
        }
      if (neighbor.delay == best.delay && neighbor.tau == best.tau)
        stride = {0.5 * stride.delay, 0.5 * stride.tau};
      best = neighbor;
    }
    return best;
  }

  /// The distance from the best value of one member of Lag, in one direction, at which the residual
  /// has increased by its variance; `spread` becomes the change of the gain up to there, if that is
  /// greater.
  double distance(const Lag& best, const LagFit& fit, double Lag::*member, double direction,
                  double& spread) const {
    double Lag::*other = member == &Lag::delay ? &Lag::tau : &Lag::delay;
    const double bound = fit.residual + fit.variance();
    const auto residual_of = [this](const Lag& lag) { return evaluate(lag).residual; };
    const auto is_within = [&](double step) {
      Lag lag = best, stride;
      lag.*member += direction * step;
      stride.*other = 0.01;
      const LagFit moved = evaluate(search(lag, stride, residual_of));
      if (moved.residual > bound) return false;
      spread = std::max(spread, std::abs(moved.gain - fit.gain));
      return true;
    };
    const double end = direction > 0 ? (member == &Lag::delay ? max_delay_ : kMaxTau) - best.*member
                                     : best.*member;
    double low = 0, high = 1e-4;  // s
    while (high < end && is_within(high)) {
      low = high;
      high *= 2;
    }
    high = std::min(high, end);
    constexpr int kBisections = 6;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (low + high);
      (is_within(middle) ? low : high) = middle;
    }
    return high;
  }

  /// The mean of both directions, or that upwards if the other ends at 0.
  double standard_error(const Lag& best, const LagFit& fit, double Lag::*member,
                        double& spread) const {
    const double up = distance(best, fit, member, 1, spread);
    const double down = distance(best, fit, member, -1, spread);
    return down < best.*member ? 0.5 * (up + down) : up;
  }

  ResponseFit estimate(const Lag& lag) const {
    const LagFit fit = evaluate(lag);
    ResponseFit result;
    result.samples = fit.samples;
    if (fit.samples < kMinVelocities)
      result.problem = "only " + std::to_string(fit.samples) +
                       " velocities measured while the acceleration is not limited; expected " +
                       std::to_string(kMinVelocities);
    else if (!(fit.gain > 0 && fit.variance() < 0.5 * fit.total_variance()))
      result.problem = "the velocity does not follow the commands";
    else if (lag.delay > max_delay_ - kSameTime)
      result.problem = "the delay exceeds the maximum of " + format_number(max_delay_) + " s";
    else if (lag.tau > kMaxTau - kSameTime)
      result.problem = "the time constant exceeds " + format_number(kMaxTau) + " s";
    if (!result.problem.empty()) return result;
    double by_delay = 0, by_tau = 0;
    result.delay = Value::of(lag.delay, standard_error(lag, fit, &Lag::delay, by_delay));
    result.delay_tau = Value::of(lag.tau, standard_error(lag, fit, &Lag::tau, by_tau));
    result.gain = Value::of(fit.gain, std::sqrt(fit.variance() / fit.information +
                                                std::pow(std::max(by_delay, by_tau), 2)));
    return result;
  }

  const ResponseData& data_;
  double max_delay_;
  double start_ = 0;           ///< the first velocity, divided by the gain
  std::vector<char> limited_;  ///< not fitted: the interval that ends with this velocity
};

/// The velocities whose delayed command is known for every delay, at increasing times.
ResponseData usable_part(const ResponseData& data, double max_delay) {
  ResponseData part = data;
  part.times.clear();
  part.measured.clear();
  if (data.command_times.empty()) return part;
  for (std::size_t k = 0; k < data.times.size(); ++k) {
    const double t = data.times[k];
    if (t < data.command_times.front() + max_delay || t > data.command_times.back() + kSameTime ||
        (!part.times.empty() && t < part.times.back() + kSameTime))
      continue;
    part.times.push_back(t);
    part.measured.push_back(data.measured[k]);
  }
  return part;
}

bool is_constant(const std::vector<double>& velocities) {
  constexpr double kSameVelocity = 1e-3;  // m/s, rad/s
  const auto [low, high] = std::minmax_element(velocities.begin(), velocities.end());
  return *high - *low < kSameVelocity;
}

}  // namespace

ResponseFit fit_response(const ResponseData& data, double max_delay) {
  const ResponseData part = usable_part(data, max_delay);
  ResponseFit failed;
  failed.samples = part.times.size();
  if (part.times.size() < kMinVelocities)
    failed.problem = "only " + std::to_string(part.times.size()) + " velocities measured from " +
                     format_number(max_delay) +
                     " s after the first command to the last; expected " +
                     std::to_string(kMinVelocities);
  else if (is_constant(part.commands))
    failed.problem = "the commanded velocity is constant";
  else if (is_constant(part.measured))
    failed.problem = "the measured velocity is constant";
  return failed.problem.empty() ? ResponseFitter(part, max_delay).fit() : failed;
}

}  // namespace slalom
