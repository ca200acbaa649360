#pragma once

#include <string>
#include <vector>

namespace slalom {

/// 1, 2 or 5 times a power of ten.
struct RoundStep {
  int digit = 1;
  int exponent = 0;

  double size() const { return times(1); }
  /// `count` steps, correctly rounded: 3 steps of 0.1 are 0.3.
  double times(double count) const;
  /// The label of a multiple of the step, with the digits that the step needs.
  std::string label(double value) const;
};

/// The smallest step that divides [low, high] into at most `max_steps` parts (at least 1). For an
/// empty range, a step that is small relative to its value.
RoundStep round_step(double low, double high, int max_steps);

/// Maps values to pixels along one axis of a plot.
class PlotAxis {
 public:
  PlotAxis() = default;
  /// `low` is drawn at `low_pixel`. An empty range is widened around its value.
  PlotAxis(double low, double high, double low_pixel, double high_pixel);

  double low() const { return low_; }
  double high() const { return high_; }
  double to_pixel(double value) const;
  double to_value(double pixel) const;

  struct Tick {
    double value;
    std::string label;
  };
  /// At most `max_steps` + 1 round values within the range.
  std::vector<Tick> ticks(int max_steps) const;

 private:
  double low_ = 0, high_ = 1;
  double low_pixel_ = 0, high_pixel_ = 1;
};

}  // namespace slalom
