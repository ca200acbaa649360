// SPDX-License-Identifier: BSD-3-Clause
// Scans, which vectors of rays compute in single precision, against single rays in double
// precision, from cell to cell.
#include "one_target.h"
#include "random_worlds.h"

#include <slalom/scenario/ray_caster.h>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <array>
#include <cstdint>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kTouch = 1e-9;  ///< as documented at RayCaster

/// A ray (cells) in a grid that is mirrored so that it goes up and to the right.
struct ReferenceRay {
  const Occupancy& cells;
  bool left, down;
  double x, y, dx, dy;

  ReferenceRay(const Occupancy& grid, const TPoint2D& at, double cosine, double sine)
      : cells(grid), left(cosine < 0), down(sine < 0) {
    const TPoint2D position = cells.to_cells(at);
    x = left ? cells.size_x() - position.x : position.x;
    y = down ? cells.size_y() - position.y : position.y;
    dx = std::abs(cosine) < 1e-14 ? 0 : std::abs(cosine);
    dy = std::abs(sine) < 1e-14 ? 0 : std::abs(sine);
  }

  bool occupied(int cx, int cy) const {
    return cells.occupied(left ? cells.size_x() - 1 - cx : cx, down ? cells.size_y() - 1 - cy : cy);
  }
  bool touches(int cx, int cy) const {
    return occupied(cx, cy) || occupied(cx - 1, cy) || occupied(cx, cy - 1) ||
           occupied(cx - 1, cy - 1);
  }
  bool starts_free() const {
    for (const double at_x : {x - kTouch, x + kTouch})
      for (const double at_y : {y - kTouch, y + kTouch})
        if (occupied(static_cast<int>(std::floor(at_x)), static_cast<int>(std::floor(at_y))))
          return false;
    return true;
  }

  double range() const {
    if (dx == 0) return std::min(along(y, x, true), along(y, x + 2 * kTouch, true));
    if (dy == 0) return std::min(along(x, y, false), along(x, y + 2 * kTouch, false));
    int cx = static_cast<int>(x), cy = static_cast<int>(y);
    for (;;) {
      const double tx = (cx + 1 - x) * (1 / dx), ty = (cy + 1 - y) * (1 / dy);
      const bool through_x = tx < ty;
      const double t = through_x ? tx : ty, other = through_x ? y + t * dy : x + t * dx;
      const int nearest = static_cast<int>(std::lround(other));
      cx = through_x ? cx + 1 : std::max(cx, static_cast<int>(other));
      cy = through_x ? std::max(cy, static_cast<int>(other)) : cy + 1;
      if (std::abs(other - nearest) < kTouch &&
          touches(through_x ? cx : nearest, through_x ? nearest : cy))
        return through_x ? std::min(t, (nearest - y) * (1 / dy))
                         : std::min(t, (nearest - x) * (1 / dx));
      if (occupied(cx, cy)) return t;
    }
  }

 private:
  /// Along an axis; `across` + kTouch is the row or column that is looked at.
  double along(double start, double across, bool upwards) const {
    const int row = static_cast<int>(across - kTouch);
    int cell = static_cast<int>(start);
    while (!(upwards ? occupied(row, cell) : occupied(cell, row))) ++cell;
    return cell - start;
  }
};

/// The expected result of RayCaster::cast_scan.
std::vector<float> reference_scan(const Occupancy& cells, const mrpt::math::TPose2D& pose,
                                  const ScanGeometry& geometry) {
  std::vector<float> ranges;
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  const double limit = geometry.max_range / cells.resolution();
  for (int i = 0; i < geometry.count; ++i) {
    const double along = std::cos(geometry.angle(i)), across = std::sin(geometry.angle(i));
    const ReferenceRay ray(cells, {pose.x, pose.y}, c * along - s * across, s * along + c * across);
    const double range = ray.starts_free() ? std::min(limit, ray.range()) : 0;
    ranges.push_back(static_cast<float>(std::min(geometry.max_range, cells.resolution() * range)));
  }
  return ranges;
}

struct ScanSetup {
  mrpt::math::TPose2D pose;
  ScanGeometry geometry;
};

/// Half of the scans are taken where many rays pass through corners and along borders.
ScanSetup random_scan(RandomEngine& random, const Occupancy& cells) {
  const TPoint2D at = testing::random_point(random, cells.bounds(), cells.resolution());
  const std::array<double, 4> max_ranges = {0.3, uniform_real(random, 0.5, 9), 100, 1e9};
  const ScanGeometry geometry{uniform_int(random, 1, 400), uniform_real(random, 0.1, 2 * M_PI),
                              max_ranges[static_cast<std::size_t>(uniform_int(random, 0, 3))]};
  const TPoint2D corner = cells.to_world(0.5 * uniform_int(random, 0, 2 * cells.size_x()),
                                         0.5 * uniform_int(random, 0, 2 * cells.size_y()));
  if (uniform_int(random, 0, 1) == 0) return {{at.x, at.y, uniform_real(random, -4, 4)}, geometry};
  return {{corner.x, corner.y, M_PI / 4 * uniform_int(random, -4, 4)},
          {uniform_int(random, 0, 1) ? 181 : 9, M_PI, geometry.max_range}};
}

/// Instruction sets of this machine that the program is compiled for.
std::vector<std::int64_t> instruction_sets() {
  std::vector<std::int64_t> sets;
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1)
    sets.push_back(left & -left);
  return sets;
}

void expect_reference_scans(const Occupancy& cells, const std::vector<ScanSetup>& scans) {
  std::vector<std::vector<float>> expected;
  for (const ScanSetup& scan : scans)
    expected.push_back(reference_scan(cells, scan.pose, scan.geometry));
  for (const std::int64_t set : instruction_sets()) {
    const testing::OneTarget used(set);
    const RayCaster caster(cells);
    for (std::size_t n = 0; n < scans.size(); ++n) {
      std::vector<float> ranges(expected[n].size(), -1);
      caster.cast_scan(scans[n].pose, scans[n].geometry, ranges.data());
      for (std::size_t i = 0; i < ranges.size(); ++i)
        ASSERT_EQ(ranges[i], expected[n][i]) << hwy::TargetName(set) << ", ray " << i;
    }
  }
}

TEST(Scan, IsBitIdenticalToSingleRaysInDoublePrecisionWithEveryInstructionSet) {
  RandomEngine random(24);
  for (int n = 0; n < 400; ++n) {
    const Occupancy cells = testing::random_occupancy(random, 80);
    std::vector<ScanSetup> scans;
    for (int i = 0; i < 3; ++i) scans.push_back(random_scan(random, cells));
    expect_reference_scans(cells, scans);
  }
}

/// Errors of single precision grow with the distance and with the slope.
TEST(Scan, IsBitIdenticalOverThousandsOfCellsAndAlmostAlongAxes) {
  RandomEngine random(25);
  for (const bool wide : {false, true}) {
    Occupancy cells(wide ? 5000 : 900, wide ? 60 : 700, 0.01, {-3, 2});
    for (int i = 0; i < 300; ++i)
      cells.set_occupied(uniform_int(random, 0, cells.size_x() - 1),
                         uniform_int(random, 0, cells.size_y() - 1), true);
    std::vector<ScanSetup> scans;
    for (int i = 0; i < 40; ++i) {
      const TPoint2D at = testing::random_point(random, cells.bounds());
      const double aperture = std::pow(10.0, uniform_real(random, -8, 0.7));
      const double heading =
          M_PI / 2 * uniform_int(random, 0, 3) + uniform_real(random, -1, 1) * aperture;
      scans.push_back({{at.x, at.y, heading}, {361, aperture, 100}});
    }
    expect_reference_scans(cells, scans);
  }
}

}  // namespace
}  // namespace slalom
