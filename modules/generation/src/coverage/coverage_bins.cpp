// SPDX-License-Identifier: BSD-3-Clause
#include "coverage_bins.h"

#include <algorithm>

namespace slalom {

CoverageBins::CoverageBins(std::vector<CoverageAxis> axes) : axes_(std::move(axes)) {
  for (const CoverageAxis& axis : axes_) size_ *= axis.size();
}

std::vector<std::size_t> CoverageBins::position(std::size_t bin) const {
  std::vector<std::size_t> position(axes_.size());
  for (std::size_t i = axes_.size(); i-- > 0; bin /= axes_[i].size())
    position[i] = bin % axes_[i].size();
  return position;
}

std::pair<double, double> CoverageBins::interval(std::size_t bin, std::size_t axis) const {
  const std::size_t slot = position(bin)[axis];
  return {axes_[axis].edges[slot], axes_[axis].edges[slot + 1]};
}

std::optional<std::size_t> CoverageBins::slot(std::size_t axis, double value) const {
  const std::vector<double>& edges = axes_[axis].edges;
  if (!(value >= edges.front() && value <= edges.back())) return std::nullopt;
  const auto above = std::upper_bound(edges.begin(), edges.end(), value);
  return std::min(static_cast<std::size_t>(above - edges.begin()) - 1, axes_[axis].size() - 1);
}

std::optional<std::size_t> CoverageBins::find(const std::vector<double>& point) const {
  std::size_t bin = 0;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto at = slot(i, point[i]);
    if (!at) return std::nullopt;
    bin = bin * axes_[i].size() + *at;
  }
  return bin;
}

double CoverageBins::gap(std::size_t bin, std::size_t axis, double value) const {
  const auto [low, high] = interval(bin, axis);
  const std::vector<double>& edges = axes_[axis].edges;
  return std::max({0.0, low - value, value - high}) / (edges.back() - edges.front());
}

double CoverageBins::distance(std::size_t bin, const std::vector<double>& point) const {
  double sum = 0;
  for (std::size_t i = 0; i < axes_.size(); ++i) sum += gap(bin, i, point[i]);
  return sum;
}

}  // namespace slalom
