// SPDX-License-Identifier: BSD-3-Clause
#include "delayed_response.h"
#include "lag_fit.h"
#include "response_fit.h"

#include <slalom/core/math.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace slalom {
namespace {

constexpr double kMaxTau = 5;  // s
constexpr std::size_t kMinVelocities = 20;

/// The parameters of the response that are not linear, or strides of a search for them.
struct Lag {
  double delay = 0, tau = 0;  // s
  double log_limit = 0;       // of the limit of acceleration

  Lag moved(const Lag& stride, int i, int j, int k) const {
    return {delay + i * stride.delay, tau + j * stride.tau, log_limit + k * stride.log_limit};
  }
};

class ResponseFitter {
 public:
  ResponseFitter(ResponseData data, double max_delay)
      : data_(std::move(data)), max_delay_(max_delay) {
    const Lag stride = {max_delay_ / kGridDelays, 0.05, 0};
    best_ = search(best_of_grid(), stride, kFineStride);
    const double gain = evaluate(best_).gain;
    if (!(gain > 0)) return;
    start_ = data_.measured.front() / gain;
    if (data_.max_acceleration > 0) {
      is_limited_ = true;
      best_ = search(best_, stride, kFineStride);
    } else {
      find_limit(greatest_acceleration() / gain);
    }
  }

  std::string problem() const {
    const LagFit fit = evaluate(best_);
    if (!(fit.gain > 0 && fit.residual < 0.5 * fit.total))
      return "the velocity does not follow the commands";
    if (best_.delay > max_delay_ - kSameTime)
      return "the delay exceeds the maximum of " + format_number(max_delay_) + " s";
    if (best_.tau > kMaxTau - kSameTime)
      return "the time constant exceeds " + format_number(kMaxTau) + " s";
    return "";
  }

  Profile profile_of(double Lag::*member) const {
    const double highest = member == &Lag::delay ? max_delay_ : kMaxTau;
    return profile(best_.*member, highest, [this, member](double value) {
      Lag lag = best_, stride = strides();
      lag.*member = value;
      stride.*member = 0;
      return evaluate(search(lag, stride, kProfileStride)).residual;
    });
  }

  Profile gain() const {
    return profile(evaluate(best_).gain, kMaxGain, [this](double gain) {
      const auto residual_of = [&](const Lag& lag) { return evaluate(lag).residual_with(gain); };
      return residual_of(search_least(best_, strides(), kProfileStride, residual_of));
    });
  }

 private:
  static constexpr int kGridDelays = 40;
  static constexpr double kMaxGain = 1e3;
  static constexpr double kFineStride = 1e-5, kProfileStride = 1e-4, kRoughStride = 1e-3;  // s

  Lag strides() const { return {0.01, 0.01, is_free_ ? 0.02 : 0}; }

  /// Makes the profile of a parameter from `residual_of`, the smallest sum of squares by its value.
  template <typename Residual>
  Profile profile(double best, double highest, Residual residual_of) const {
    const double parameters = is_free_ ? 5 : 4;
    const double freedom = static_cast<double>(data_.times.size()) - parameters;
    const double least = evaluate(best_).residual;
    const double variance = std::max(least / freedom, kModelAccuracy * kModelAccuracy);
    return {best, 0, highest, freedom, [residual_of, least, variance](double value) {
              return (residual_of(value) - least) / variance;
            }};
  }

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

  /// Adds a limit of acceleration if the log is much more likely with it.
  void find_limit(double greatest) {
    // A limit that is active for less than the time between two velocities exceeds all measured.
    constexpr double kExcess = 1.5, kRatio = 0.85;
    constexpr int kCandidates = 18;
    constexpr double kMuchMoreLikely = 20;  // twice the logarithm of the likelihoods
    const double without = evaluate(best_).residual;
    Lag lag = best_, best = best_;
    double least = without;
    is_limited_ = true;
    for (int i = 0; i < kCandidates; ++i) {
      lag.log_limit = math::log(kExcess * greatest) + i * math::log(kRatio);
      lag = search(lag, {max_delay_ / kGridDelays, 0.05, 0}, kRoughStride);
      const double residual = evaluate(lag).residual;
      if (residual >= least) continue;
      least = residual;
      best = lag;
    }
    best = search(best, {0.01, 0.01, 0.1}, kFineStride);
    const auto n = static_cast<double>(data_.times.size());
    const double accuracy = n * kModelAccuracy * kModelAccuracy;
    const double gained =
        n * math::log((without + accuracy) / (evaluate(best).residual + accuracy));
    is_limited_ = is_free_ = gained > kMuchMoreLikely;
    if (is_free_) best_ = best;
  }

  LagFit evaluate(const Lag& lag) const {
    double limit = kNoLimit;
    if (is_limited_)
      limit = data_.max_acceleration > 0 ? data_.max_acceleration : math::exp(lag.log_limit);
    LaggedVelocity response(start_, lag.tau, limit);
    ResponseSums sums;
    sums.add(1, start_, data_.measured[0]);
    DelayedCommands commands(data_, lag.delay);
    for (std::size_t k = 1; k < data_.times.size(); ++k) {
      commands.advance(data_.times[k - 1], data_.times[k], [&](double command, double duration) {
        response.advance(command, duration);
      });
      sums.add(response.decay(), response.velocity(), data_.measured[k]);
    }
    return sums.solve();
  }

  Lag best_of_grid() const {
    std::vector<double> taus = {0};
    for (double tau = 0.01; tau < kMaxTau; tau *= 1.3) taus.push_back(tau);
    Lag best;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kGridDelays; ++i)
      for (const double tau : taus) {
        const Lag lag = {i * max_delay_ / kGridDelays, tau, 0};
        const double residual = evaluate(lag).residual;
        if (residual < least) {
          least = residual;
          best = lag;
        }
      }
    return best;
  }

  Lag search(const Lag& best, const Lag& stride, double min_stride) const {
    return search_least(best, stride, min_stride,
                        [this](const Lag& lag) { return evaluate(lag).residual; });
  }

  /// Pattern search: moves to the best neighbor, or halves the strides if there is no better one. A
  /// stride of 0 keeps that parameter.
  template <typename Residual>
  Lag search_least(Lag best, Lag stride, double min_stride, Residual residual_of) const {
    double least = residual_of(best);
    while (std::max(stride.delay, stride.tau) > min_stride) {
      Lag neighbor = best;
      bool is_better = false;
      const auto ends = [](double length) { return length > 0 ? 1 : 0; };
      for (int i = -ends(stride.delay); i <= ends(stride.delay); ++i)
        for (int j = -ends(stride.tau); j <= ends(stride.tau); ++j)
          for (int k = -ends(stride.log_limit); k <= ends(stride.log_limit); ++k) {
            if (i == 0 && j == 0 && k == 0) continue;
            Lag lag = best.moved(stride, i, j, k);
            lag.delay = std::clamp(lag.delay, 0.0, max_delay_);
            lag.tau = std::clamp(lag.tau, 0.0, kMaxTau);
            const double residual = residual_of(lag);
            if (residual >= least) continue;
            least = residual;
            neighbor = lag;
            is_better = true;
          }
      if (!is_better) stride = {0.5 * stride.delay, 0.5 * stride.tau, 0.5 * stride.log_limit};
      best = neighbor;
    }
    return best;
  }

  const ResponseData data_;
  double max_delay_;
  double start_ = 0;         ///< the first velocity, divided by the gain
  bool is_limited_ = false;  ///< the acceleration
  bool is_free_ = false;     ///< its limit is fitted
  Lag best_;
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
  ResponseFit fit;
  fit.samples = part.times.size();
  if (part.times.size() < kMinVelocities)
    fit.problem = "only " + std::to_string(part.times.size()) + " velocities measured from " +
                  format_number(max_delay) + " s after the first command to the last; expected " +
                  std::to_string(kMinVelocities);
  else if (is_constant(part.commands))
    fit.problem = "the commanded velocity is constant";
  else if (is_constant(part.measured))
    fit.problem = "the measured velocity is constant";
  if (!fit.problem.empty()) return fit;
  const auto fitter = std::make_shared<ResponseFitter>(part, max_delay);
  fit.problem = fitter->problem();
  fit.delay = fitter->profile_of(&Lag::delay);
  fit.delay_tau = fitter->profile_of(&Lag::tau);
  fit.gain = fitter->gain();
  for (Profile* profile : {&fit.delay, &fit.delay_tau, &fit.gain})
    profile->deviance = [fitter, deviance = profile->deviance](double x) { return deviance(x); };
  return fit;
}

}  // namespace slalom
