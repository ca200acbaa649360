#pragma once

#include <slalom/studio/palette.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// One line of a plot. `x` is ascending and as long as `y`; NaN in `y` is a gap.
struct LineSeries {
  std::string name;
  Color color;
  std::vector<double> x, y;

  /// Linear interpolation at `at`; nullopt outside the samples and in gaps.
  std::optional<double> value_at(double at) const;
};

/// The minimum and maximum of the finite numbers; nullopt if there are none.
std::optional<std::pair<double, double>> range_of(const std::vector<double>& numbers);

/// Indices of the samples that suffice to draw the line on this many pixel columns: of each column
/// the first, the minimum, the maximum and the last sample, and every gap.
std::vector<std::size_t> downsampled(const LineSeries& series, double x_low, double x_high,
                                     int columns);

}  // namespace slalom
