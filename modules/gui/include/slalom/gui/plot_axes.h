#pragma once

#include <string>
#include <vector>

namespace slalom {

/// 1, 2 or 5 times a power of ten.
struct RoundStep {
  int digit = 1;
  int exponent = 0;

  double size() const { return times(1); }
  /// The double nearest to `count` steps, so that 3 steps of 0.1 are 0.3.
  double times(double count) const;
  /// Of a multiple of the step, with just the digits that the step needs.
  std::string label(double value) const;
};

/// The least step that cuts [low, high] into at most `most` parts. Of an empty range: one that is
/// small beside its value. `most` is at least 1.
RoundStep round_step(double low, double high, int most);

/// How values lie along one direction of a plot.
class PlotAxis {
 public:
  PlotAxis() = default;
  /// `low` is shown at `low_pixel`. An empty range is widened about its value.
  PlotAxis(double low, double high, double low_pixel, double high_pixel);

  double low() const { return low_; }
  double high() const { return high_; }
  double to_pixel(double value) const;
  double to_value(double pixel) const;

  struct Tick {
    double value;
    std::string label;
  };
  /// At most `most` + 1 round values within the range.
  std::vector<Tick> ticks(int most) const;

 private:
  double low_ = 0, high_ = 1;
  double low_pixel_ = 0, high_pixel_ = 1;
};

}  // namespace slalom
