#pragma once

#include <nanogui/common.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// One line of a plot. `x` grows and is as long as `y`; NaN in `y` is a gap.
struct LineSeries {
  std::string name;
  nanogui::Color color;
  std::vector<double> x, y;

  /// Between the samples beside `at`; nullopt outside of them and in gaps.
  std::optional<double> value_at(double at) const;
};

/// The least and the largest number among some; nullopt when there is none that is finite.
std::optional<std::pair<double, double>> range_of(const std::vector<double>& numbers);

/// Indices of samples that show the same line as all of them at this many pixels across: of each
/// column the first, the least, the largest and the last, and every gap.
std::vector<std::size_t> thinned(const LineSeries& series, double x_low, double x_high,
                                 int columns);

}  // namespace slalom
