// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/coverage.h>

#include <optional>

namespace slalom {

/// The bins of a plan, numbered with the first axis varying slowest.
class CoverageBins {
 public:
  explicit CoverageBins(std::vector<CoverageAxis> axes);

  std::size_t size() const { return size_; }
  const std::vector<CoverageAxis>& axes() const { return axes_; }
  std::vector<std::size_t> position(std::size_t bin) const;
  std::pair<double, double> interval(std::size_t bin, std::size_t axis) const;
  /// Index of the interval of a value along an axis; nullopt outside all bins.
  std::optional<std::size_t> slot(std::size_t axis, double value) const;
  /// The bin of a point in descriptor space.
  std::optional<std::size_t> find(const std::vector<double>& point) const;
  /// Distance of a value from a bin along one axis, as a fraction of the axis; 0 inside.
  double gap(std::size_t bin, std::size_t axis, double value) const;
  /// Sum of the gaps along all axes.
  double distance(std::size_t bin, const std::vector<double>& point) const;

 private:
  std::vector<CoverageAxis> axes_;
  std::size_t size_ = 1;
};

}  // namespace slalom
