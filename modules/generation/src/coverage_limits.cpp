#include "coverage_limits.h"

#include <slalom/core/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRounding = 1e-6;
/// Confinement is measured on a sample of standard error 0.005: four of them.
constexpr double kSamplingSlack = 0.02;
/// Mean distance from the centre of a unit square to its points.
constexpr double kMeanDistanceInSquare = 0.3826;

template <typename Function>
double midpoint_mean(double low, double high, Function f) {
  constexpr int kSteps = 2000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += f(low + (high - low) * (i + 0.5) / kSteps);
  return sum / kSteps;
}

/// Share of a disc of radius 1 that lies in another one at distance `s`.
double shared_by_discs(double s) {
  if (s >= 2) return 0;
  return (2 * std::acos(s / 2) - s / 2 * std::sqrt(4 - s * s)) / kPi;
}

/// Mean over directions of min(1, R / longest chord of the square).
double chord_bound(double side, double range) {
  return midpoint_mean(0, kPi / 4,
                       [&](double angle) { return std::min(1.0, range * std::cos(angle) / side); });
}

/// 1 - mean over the disc of that area of the share of a disc of radius R that lies in it.
double disc_bound(double free_area, double range) {
  const double radius = std::sqrt(free_area / kPi);
  const double within = midpoint_mean(
      0, range, [&](double s) { return 2 * s / range * shared_by_discs(s / radius); });
  return 1 - within;
}

/// Proofs about one bin.
class Proof {
 public:
  Proof(const CoverageBins& bins, std::size_t bin, const CoverageOptions& options,
        const CoverageTask& task)
      : bins_(bins), bin_(bin), options_(options), task_(task) {
    cell_ = std::max(task.resolution, kCoarsestCell);
    side_ = options.max_floor + cell_;
    free_area_ = side_ * side_ * (1 - std::clamp(least_density(), 0.0, 1.0));
  }

  std::optional<std::string> find() const {
    for (std::size_t i = 0; i < bins_.axes().size(); ++i) {
      const auto [low, high] = bins_.interval(bin_, i);
      if (auto why = of_axis(bins_.axes()[i].id, low, high)) return why;
    }
    return std::nullopt;
  }

 private:
  double least_density() const {
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
    if (low > 1) return id + " is a share, at most 1";
    if (high < 0) return id + " is a share, at least 0";
    return further();
  }

  std::optional<std::string> of_density(double low) const {
    const double limit = density_limit(task_.robot_radius, options_.min_distance, side_);
    if (low <= limit + kRounding) return std::nullopt;
    return fmt::format(
        "a robot of radius {} m that goes {} m leaves at most {:.4f} of a floor of {} m to "
        "obstacles",
        format_number(task_.robot_radius), format_number(options_.min_distance), limit,
        format_number(options_.max_floor));
  }

  std::optional<std::string> of_clearness(double low) const {
    const double limit = clearness_limit(free_area_, task_.sensor_range) +
                         kMeanDistanceInSquare * cell_ / task_.sensor_range;
    if (low <= limit + kRounding) return std::nullopt;
    return fmt::format(
        "no free space of at most {:.0f} m^2 has a clearness above {:.4f} (that of a disc)",
        free_area_, limit);
  }

  std::optional<std::string> of_confinement(double high) const {
    const double limit = confinement_limit(free_area_, side_, task_.sensor_range) - kSamplingSlack;
    if (high >= limit - kRounding) return std::nullopt;
    return fmt::format(
        "no free space of at most {:.0f} m^2 on a floor of {} m is measured as less confined than "
        "{:.4f}",
        free_area_, format_number(options_.max_floor), limit);
  }

  std::optional<std::string> of_bottleneck(double low, double high) const {
    if (high < 2 * task_.robot_radius - kRounding)
      return fmt::format("the robot is {} m wide", format_number(2 * task_.robot_radius));
    if (low > side_)
      return fmt::format("the floor is at most {} m wide", format_number(options_.max_floor));
    return std::nullopt;
  }

  const CoverageBins& bins_;
  std::size_t bin_;
  const CoverageOptions& options_;
  const CoverageTask& task_;
  double cell_ = 0, side_ = 0, free_area_ = 0;
};

}  // namespace

double density_limit(double robot_radius, double min_distance, double side) {
  const double way = 2 * robot_radius * min_distance + kPi * robot_radius * robot_radius;
  return 1 - way / (side * side);
}

double clearness_limit(double free_area, double sensor_range) {
  if (!(free_area > 0)) return 0;
  const double radius = std::sqrt(free_area / kPi);
  const double rest = std::max(0.0, 1 - sensor_range / radius);
  return radius / (3 * sensor_range) * (1 - rest * rest * rest);
}

double confinement_limit(double free_area, double side, double sensor_range) {
  if (!(free_area > 0)) return 1;
  return std::max(chord_bound(side, sensor_range), disc_bound(free_area, sensor_range));
}

std::optional<std::string> why_impossible(const CoverageBins& bins, std::size_t bin,
                                          const CoverageOptions& options,
                                          const CoverageTask& task) {
  return Proof(bins, bin, options, task).find();
}

}  // namespace slalom
