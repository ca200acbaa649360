// SPDX-License-Identifier: BSD-3-Clause
#include "coverage_limits.h"

#include <slalom/core/math.h>
#include <slalom/core/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kRounding = 1e-6;
/// Confinement is measured on a sample of standard error 0.005: four of them.
constexpr double kSamplingSlack = 0.02;
/// Mean distance from the center of a unit square to its points.
constexpr double kMeanDistanceInSquare = 0.3826;

template <typename Function>
double midpoint_mean(double low, double high, Function f) {
  constexpr int kSteps = 2000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += f(low + (high - low) * (i + 0.5) / kSteps);
  return sum / kSteps;
}

/// Fraction of a unit disc that overlaps another one at distance `s`.
double disc_overlap(double s) {
  if (s >= 2) return 0;
  return (2 * math::acos(s / 2) - s / 2 * std::sqrt(4 - s * s)) / M_PI;
}

/// Mean over directions of min(1, R / longest chord of the square).
double chord_bound(double side, double range) {
  return midpoint_mean(
      0, M_PI / 4, [&](double angle) { return std::min(1.0, range * math::cos(angle) / side); });
}

/// 1 - mean over a disc of that area of the fraction of a disc of radius R that overlaps it.
double disc_bound(double free_area, double range) {
  const double radius = std::sqrt(free_area / M_PI);
  const double within =
      midpoint_mean(0, range, [&](double s) { return 2 * s / range * disc_overlap(s / radius); });
  return 1 - within;
}

/// Proofs about one bin.
class Proof {
 public:
  Proof(const CoverageBins& bins, std::size_t bin, const CoverageOptions& options,
        const CoverageSettings& settings)
      : bins_(bins), bin_(bin), options_(options), settings_(settings) {
    radius_ = settings.footprint ? settings.footprint->inscribed_radius() : settings.robot_radius;
    cell_ = std::max(settings.resolution, kMaxCellSize);
    side_ = options.max_extent + cell_;
    free_area_ = side_ * side_ * (1 - std::clamp(min_density(), 0.0, 1.0));
  }

  std::optional<std::string> run() const {
    for (std::size_t i = 0; i < bins_.axes().size(); ++i) {
      const auto [low, high] = bins_.interval(bin_, i);
      if (auto reason = of_axis(bins_.axes()[i].id, low, high)) return reason;
    }
    return std::nullopt;
  }

 private:
  double min_density() const {
    for (std::size_t i = 0; i < bins_.axes().size(); ++i)
      if (bins_.axes()[i].id == "density") return bins_.interval(bin_, i).first;
    return 0;
  }

  std::optional<std::string> of_axis(const std::string& id, double low, double high) const {
    if (id == "density") return in_unit(id, low, high, [&] { return of_density(low); });
    if (id == "clearness") return in_unit(id, low, high, [&] { return of_clearness(low); });
    if (id == "confinement") return in_unit(id, low, high, [&] { return of_confinement(high); });
    if (id == "bottleneck_width") return of_bottleneck(low, high);
    if (id == "detour_ratio" && high < 1 - kRounding)
      return "no path is shorter than the straight line";
    return std::nullopt;
  }

  template <typename Further>
  static std::optional<std::string> in_unit(const std::string& id, double low, double high,
                                            Further further) {
    if (low > 1) return id + " is a fraction, at most 1";
    if (high < 0) return id + " is a fraction, at least 0";
    return further();
  }

  std::optional<std::string> of_density(double low) const {
    const double limit = density_limit(radius_, options_.min_distance, side_);
    if (low <= limit + kRounding) return std::nullopt;
    return fmt::format(
        "a robot {} radius {} m with a path of {} m leaves at most {:.4f} of a workspace of {} m "
        "for obstacles",
        settings_.footprint ? "with an inscribed disc of" : "of", format_number(radius_),
        format_number(options_.min_distance), limit, format_number(options_.max_extent));
  }

  std::optional<std::string> of_clearness(double low) const {
    const double limit = clearness_limit(free_area_, settings_.sensor_range) +
                         kMeanDistanceInSquare * cell_ / settings_.sensor_range;
    if (low <= limit + kRounding) return std::nullopt;
    return fmt::format(
        "no free space of at most {:.0f} m^2 has a clearness above {:.4f} (that of a disc)",
        free_area_, limit);
  }

  std::optional<std::string> of_confinement(double high) const {
    const double limit =
        confinement_limit(free_area_, side_, settings_.sensor_range) - kSamplingSlack;
    if (high >= limit - kRounding) return std::nullopt;
    return fmt::format(
        "no free space of at most {:.0f} m^2 in a workspace of {} m has a measured confinement "
        "below "
        "{:.4f}",
        free_area_, format_number(options_.max_extent), limit);
  }

  std::optional<std::string> of_bottleneck(double low, double high) const {
    if (high < 2 * radius_ - kRounding)
      return fmt::format("the diameter of the {} is {:.6g} m",
                         settings_.footprint ? "disc inscribed in the robot" : "robot",
                         2 * radius_);
    if (low > side_)
      return fmt::format("the workspace is at most {} m wide", format_number(options_.max_extent));
    return std::nullopt;
  }

  const CoverageBins& bins_;
  std::size_t bin_;
  const CoverageOptions& options_;
  const CoverageSettings& settings_;
  double radius_ = 0;  // m, of a disc in the robot
  double cell_ = 0, side_ = 0, free_area_ = 0;
};

}  // namespace

double density_limit(double robot_radius, double min_distance, double side) {
  const double swept = 2 * robot_radius * min_distance + M_PI * robot_radius * robot_radius;
  return 1 - swept / (side * side);
}

double clearness_limit(double free_area, double sensor_range) {
  if (!(free_area > 0)) return 0;
  const double radius = std::sqrt(free_area / M_PI);
  const double rest = std::max(0.0, 1 - sensor_range / radius);
  return radius / (3 * sensor_range) * (1 - rest * rest * rest);
}

double confinement_limit(double free_area, double side, double sensor_range) {
  if (!(free_area > 0)) return 1;
  return std::max(chord_bound(side, sensor_range), disc_bound(free_area, sensor_range));
}

std::optional<std::string> infeasibility_reason(const CoverageBins& bins, std::size_t bin,
                                                const CoverageOptions& options,
                                                const CoverageSettings& settings) {
  return Proof(bins, bin, options, settings).run();
}

}  // namespace slalom
