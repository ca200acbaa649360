#include <slalom/core/text.h>
#include <slalom/studio/plot_axes.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr int kMaxExponent = 307;

/// The smallest step that is distinguishable in values of this magnitude.
double min_step(double low, double high) {
  constexpr double kRelative = 1e-12;
  return std::max(std::abs(low), std::abs(high)) * kRelative;
}

RoundStep round_step_above(double size) {
  const int exponent =
      std::clamp(static_cast<int>(std::floor(std::log10(size))), -kMaxExponent, kMaxExponent);
  for (const int digit : {1, 2, 5})
    if (RoundStep{digit, exponent}.size() >= size * (1 - 1e-9)) return {digit, exponent};
  return {1, exponent + 1};
}

}  // namespace

double RoundStep::times(double count) const {
  const double power = std::pow(10.0, std::abs(exponent));
  return exponent < 0 ? count * digit / power : count * digit * power;
}

std::string RoundStep::label(double value) const {
  if (value == 0) return "0";
  if (exponent < -6 || exponent > 6) return format_number(value);
  return format_fixed(value, std::max(0, -exponent));
}

RoundStep round_step(double low, double high, int max_steps) {
  double wanted = high / max_steps - low / max_steps;
  if (!(wanted > 0)) wanted = low == 0 ? 1 : 0.1 * std::abs(low);
  wanted = std::max(wanted, min_step(low, high));
  return round_step_above(wanted);
}

PlotAxis::PlotAxis(double low, double high, double low_pixel, double high_pixel)
    : low_(low), high_(high), low_pixel_(low_pixel), high_pixel_(high_pixel) {
  const double min_half = std::max(min_step(low, high), low == 0 && high == 0 ? 0.5 : 0.0);
  if (high_ - low_ >= 2 * min_half && high_ > low_) return;
  const double margin = low == 0 ? 0.5 : 0.1 * std::abs(low);
  low_ = low - margin;
  high_ = low + margin;
}

double PlotAxis::to_pixel(double value) const {
  return low_pixel_ + (value - low_) / (high_ - low_) * (high_pixel_ - low_pixel_);
}

double PlotAxis::to_value(double pixel) const {
  return low_ + (pixel - low_pixel_) / (high_pixel_ - low_pixel_) * (high_ - low_);
}

std::vector<PlotAxis::Tick> PlotAxis::ticks(int max_steps) const {
  const RoundStep step = round_step(low_, high_, std::max(max_steps, 1));
  const double slack = 1e-9 * step.size();
  std::vector<Tick> ticks;
  for (double k = std::ceil((low_ - slack) / step.size()); step.times(k) <= high_ + slack; ++k)
    ticks.push_back({step.times(k), step.label(step.times(k))});
  return ticks;
}

}  // namespace slalom
