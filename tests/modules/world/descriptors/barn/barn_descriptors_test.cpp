// SPDX-License-Identifier: BSD-3-Clause
#include "../small_worlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slalom {
namespace {

using Cell = std::pair<int, int>;  // row (along x), column (along y)

constexpr double kSize = 0.15;

mrpt::math::TPoint2D center(const Cell& cell) {
  return {(cell.first + 0.5) * kSize, (cell.second + 0.5) * kSize};
}

/// Cylinders as in BARN in a field of rows x columns, with a published path.
Scenario field(int rows, int columns, const std::vector<Cell>& obstacles,
               const std::vector<Cell>& path) {
  Primitives primitives;
  for (const Cell& cell : obstacles) primitives.discs.push_back({center(cell), kSize / 2});
  auto published = std::make_shared<PublishedPath>();
  published->field = {0, 0, rows * kSize, columns * kSize};
  published->cell_size = kSize;
  for (const Cell& cell : path) published->points.push_back(center(cell));
  return Scenario::continuous("field", {0, 0, rows * kSize + 1, columns * kSize + 2}, primitives,
                              {0.1, 0.1, 0}, {0.2, 0.1})
      .with_published_path(published);
}

double value(const std::string& id, const Scenario& scenario, int visibility = 2021) {
  const World world(scenario, 0.05);
  DescriptorContext context = context_of(world);
  context.barn_visibility = visibility;
  return value_of(id, context);
}

// One obstacle in row 5, column 3 of 15 x 7 cells: dilated, rows 3 to 7 and columns 1 to 5.
const std::vector<Cell> kOne = {{5, 3}};

TEST(BarnDescriptors, OneObstacleBelowThePath) {
  const Scenario scenario = field(15, 7, kOne, {{0, 3}});
  // Straight down to row 3.
  EXPECT_DOUBLE_EQ(value("barn_closest_distance", scenario), 3);
  // Only the ray straight down ends at the obstacle, after rows 0, 1, 2.
  EXPECT_DOUBLE_EQ(value("barn_visibility", scenario), 3);
  EXPECT_DOUBLE_EQ(value("barn_visibility", scenario, 2020), 3);
  // Along the column 2 free cells below; along the row 6; on the diagonals 3 x sqrt 2.
  EXPECT_DOUBLE_EQ(value("barn_characteristic_dimension", scenario), 2);
  // (2,1), (1,0) and (2,-1) hit it: (4,5), (3,3), (4,1). The others do not.
  EXPECT_DOUBLE_EQ(value("barn_dispersion", scenario), 2);
}

TEST(BarnDescriptors, DiagonalsCountRootTwoInTheLaterVersionOfVisibility) {
  // From (0, 0): (1,1) (2,2) are free, (3,3) is not. Down and to the right the rays leave the map.
  const Scenario scenario = field(15, 7, kOne, {{0, 0}});
  EXPECT_DOUBLE_EQ(value("barn_visibility", scenario), 3 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(value("barn_visibility", scenario, 2020), 3);
  // From (1, 2): down to (3,2): 2 cells; (1,1): (1,2) (2,3), ends at (3,4): 2; (1,-1): (1,2) (2,1),
  // (3,0) and on, leaves. (2 + 2 sqrt 2) / 2; cells: 4 / 2.
  const Scenario closer = field(15, 7, kOne, {{1, 2}});
  EXPECT_DOUBLE_EQ(value("barn_visibility", closer), 1 + std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(value("barn_visibility", closer, 2020), 2);
}

TEST(BarnDescriptors, BackwardTwoToOneRaysTakeThreeStepsAsPublished) {
  // From (12, 6), (-2,-1) hits the obstacle at its third step: (10,5) (8,4) (6,3).
  EXPECT_DOUBLE_EQ(value("barn_dispersion", field(15, 7, kOne, {{12, 6}})), 2);
  // The mirror image: from (2, 0) in a rotated field, (2,1) takes two steps only.
  EXPECT_DOUBLE_EQ(value("barn_dispersion", field(15, 7, {{9, 3}}, {{2, 0}})), 0);
}

TEST(BarnDescriptors, AreMeansOverThePathPointsIncludingDuplicates) {
  // Closest distances 3, 3 and, from (12, 6) to (7, 5), sqrt 26.
  EXPECT_DOUBLE_EQ(value("barn_closest_distance", field(15, 7, kOne, {{0, 3}, {0, 3}, {12, 6}})),
                   (6 + std::sqrt(26.0)) / 3);
  // 3 down, 4 to the right: 7 / 5; a duplicate point adds nothing.
  EXPECT_NEAR(value("barn_tortuosity", field(15, 7, kOne, {{0, 0}, {0, 0}, {3, 0}, {3, 4}})), 1.4,
              1e-12);
}

TEST(BarnDescriptors, AreZeroInAnObstacle) {
  const Scenario scenario = field(15, 7, kOne, {{4, 4}});
  for (const std::string id : {"barn_closest_distance", "barn_visibility", "barn_dispersion",
                               "barn_characteristic_dimension"})
    EXPECT_EQ(value(id, scenario), 0) << id;
}

/// An independent implementation of the descriptors, without any of the library's functions.
class ReferenceImplementation {
 public:
  ReferenceImplementation(int rows, int columns, const std::vector<Cell>& obstacles)
      : rows_(rows), columns_(columns) {
    table_.assign(static_cast<std::size_t>(rows),
                  std::string(static_cast<std::size_t>(columns), '.'));
    for (const auto& [row, column] : obstacles)
      for (int r = row - 2; r <= row + 2; ++r)
        for (int c = column - 2; c <= column + 2; ++c)
          if (in(r, c)) table_[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = '#';
  }
  bool in(int r, int c) const { return r >= 0 && c >= 0 && r < rows_ && c < columns_; }
  bool wall(int r, int c) const {
    return in(r, c) && table_[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] == '#';
  }
  double closest(int row, int column) const {
    double best = std::numeric_limits<double>::infinity();
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < columns_; ++c)
        if (wall(r, c))
          best = std::min(best, std::sqrt((r - row) * (r - row) + (c - column) * (c - column)));
    return best;
  }
  double visibility(int row, int column) const {
    double sum = 0;
    int rays = 0;
    for (int k = 0; k < 9; ++k) {
      const int dr = k / 3 - 1, dc = k % 3 - 1;
      if (k == 4) continue;
      int n = 0;
      while (in(row + n * dr, column + n * dc) && !wall(row + n * dr, column + n * dc)) ++n;
      if (!in(row + n * dr, column + n * dc)) continue;
      sum += n * std::sqrt(std::abs(dr) + std::abs(dc));
      ++rays;
    }
    return sum / rays;
  }
  double dimension(int row, int column) const {
    double min_length = 1e9;
    for (const Cell& axis : {Cell{0, 1}, Cell{1, 1}, Cell{1, 0}, Cell{1, -1}}) {
      int n = 0;
      for (const int side : {1, -1})
        for (int k = side; in(row + k * axis.first, column + k * axis.second) &&
                           !wall(row + k * axis.first, column + k * axis.second);
             k += side)
          ++n;
      min_length = std::min(min_length, n * std::sqrt(axis.first + std::abs(axis.second)));
    }
    return min_length;
  }
  double dispersion(int row, int column) const {
    const std::vector<Cell> rays = {{0, 1},  {1, 2},  {1, 1},  {2, 1},   {1, 0},   {2, -1},
                                    {1, -1}, {1, -2}, {0, -1}, {-2, -1}, {-1, -1}, {-1, -2},
                                    {-1, 0}, {-2, 1}, {-1, 1}, {-1, 2}};
    std::string hits;
    for (const auto& [dr, dc] : rays) {
      bool hit = false;
      for (int counted = 0, k = 1; counted < 3 && !hit; ++k) {
        hit = wall(row + k * dr, column + k * dc);
        counted += dr == 2 || dc == 2 ? 2 : 1;
      }
      hits += hit ? '1' : '0';
    }
    int changes = 0;
    for (std::size_t i = 0; i < 16; ++i) changes += hits[i] != hits[(i + 1) % 16] ? 1 : 0;
    return changes;
  }

 private:
  int rows_, columns_;
  std::vector<std::string> table_;
};

TEST(BarnDescriptors, EqualAReferenceImplementationOnRandomWorlds) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RandomEngine engine(seed);
    std::vector<Cell> obstacles, path;
    for (int column = 0; column < 30; ++column) {
      obstacles.emplace_back(0, column);
      obstacles.emplace_back(29, column);
    }
    for (int i = 0; i < 25; ++i)
      obstacles.emplace_back(uniform_int(engine, 0, 29), uniform_int(engine, 0, 29));
    const ReferenceImplementation second(30, 30, obstacles);
    for (int row = 3; row < 27; ++row)
      for (int column = 0; column < 30; ++column)
        if (!second.wall(row, column)) path.emplace_back(row, column);
    double sums[4] = {0, 0, 0, 0};
    for (const auto& [r, c] : path) {
      sums[0] += second.closest(r, c);
      sums[1] += second.visibility(r, c);
      sums[2] += second.dispersion(r, c);
      sums[3] += second.dimension(r, c);
    }
    const auto count = static_cast<double>(path.size());
    ASSERT_GT(count, 50);
    const Scenario scenario = field(30, 30, obstacles, path);
    EXPECT_NEAR(value("barn_closest_distance", scenario), sums[0] / count, 1e-12);
    EXPECT_NEAR(value("barn_visibility", scenario), sums[1] / count, 1e-12);
    EXPECT_NEAR(value("barn_dispersion", scenario), sums[2] / count, 1e-12);
    EXPECT_NEAR(value("barn_characteristic_dimension", scenario), sums[3] / count, 1e-12);
  }
}

TEST(BarnDescriptors, EqualGridsAndPointsGiveEqualValues) {
  const std::vector<Cell> obstacles = {{5, 3}, {5, 4}, {11, 0}}, path = {{0, 3}, {9, 6}, {13, 4}};
  const Scenario discs = field(15, 7, obstacles, path);
  mrpt::maps::COccupancyGridMap2D map(0, 15 * 0.15F, 0, 7 * 0.15F, 0.15F);
  map.fill(1.0F);
  for (const auto& [row, column] : obstacles) map.setCell(row, column, 0.0F);
  const Scenario cells = Scenario::grid("cells", map, {0.1, 0.1, 0}, {0.2, 0.1})
                             .with_published_path(discs.published_path());
  mrpt::maps::CSimplePointsMap points;
  for (const Cell& cell : obstacles)
    points.insertPoint(static_cast<float>(center(cell).x), static_cast<float>(center(cell).y));
  const Scenario dots = Scenario::points("dots", {0, 0, 3, 3}, points, {0.1, 0.1, 0}, {0.2, 0.1})
                            .with_published_path(discs.published_path());
  for (const std::string id : {"barn_closest_distance", "barn_visibility", "barn_dispersion",
                               "barn_characteristic_dimension"}) {
    EXPECT_DOUBLE_EQ(value(id, cells), value(id, discs)) << id;
    EXPECT_DOUBLE_EQ(value(id, dots), value(id, discs)) << id;
  }
}

TEST(BarnDescriptors, UseTheShortestPathWithoutAPublishedOne) {
  // 40 x 20 cells, one obstacle in row 20, column 10: dilated, rows 18 to 22, columns 8 to 12.
  Primitives obstacles;
  obstacles.discs.push_back({center({20, 10}), 0.06});
  const World world(
      Scenario::continuous("room", {0, 0, 6, 3}, obstacles, {0.5, 0.5, 0}, {5.4, 0.5}), 0.05);
  // 4.9 m along column 3 in 33 equal steps of at most a cell.
  const DescriptorContext context = context_with_path(world, {{0.52, 0.5}, {3, 0.5}, {5.42, 0.5}});
  double sum = 0;
  for (int i = 0; i <= 33; ++i) {
    const int row = static_cast<int>((0.52 + 4.9 * i / 33) / 0.15);
    sum += std::hypot(std::max({18 - row, 0, row - 22}), 8 - 3);
  }
  EXPECT_NEAR(value_of("barn_closest_distance", context), sum / 34, 1e-12);
  EXPECT_NEAR(value_of("barn_tortuosity", context), 1, 1e-12);
}

TEST(BarnDescriptors, GiveTheReasonForNa) {
  const World empty(Scenario::continuous("e", {0, 0, 6, 3}, {}, {1, 1, 0}, {5, 1}), 0.05);
  const auto reason = [](const std::string& id, const DescriptorContext& context) {
    return descriptor(id).compute(context).reason();
  };
  const DescriptorContext along = context_with_path(empty, {{1, 1}, {5, 1}});
  EXPECT_EQ(reason("barn_closest_distance", along), "no obstacles");
  EXPECT_EQ(reason("barn_visibility", along), "no ray from the path ends at an obstacle");
  EXPECT_EQ(reason("barn_dispersion", context_of(empty)), "no path given");
  EXPECT_EQ(reason("barn_tortuosity", context_of(empty)), "no path given");
  EXPECT_EQ(reason("barn_tortuosity", context_with_path(empty, {{1, 1}, {1, 1}})),
            "start and end of the path coincide");
  const World vast(Scenario::continuous("v", {0, 0, 1e6, 1e6}, {}, {1, 1, 0}, {5, 1}), 1e4);
  EXPECT_EQ(reason("barn_dispersion", context_with_path(vast, {{1, 1}, {5, 1}})),
            "the workspace has more than 4 million cells of 0.15 m");
}

TEST(BarnDescriptors, ParametersContainThePathAndTheVersion) {
  const Scenario scenario = field(15, 7, kOne, {{0, 3}}), other = field(15, 7, kOne, {{0, 4}});
  const World world(scenario, 0.05), moved(other, 0.05),
      bare(scenario.with_published_path(nullptr), 0.05);
  const auto parameters = [](const World& w, const std::string& id, int year) {
    DescriptorContext context = context_of(w);
    context.barn_visibility = year;
    return descriptor(id).key(context).parameters;
  };
  EXPECT_EQ(scenario.hash(), other.hash());
  EXPECT_NE(parameters(world, "barn_dispersion", 2021), parameters(moved, "barn_dispersion", 2021));
  EXPECT_EQ(parameters(bare, "barn_dispersion", 2021), "robot_radius=0.25;resolution=0.05");
  EXPECT_EQ(parameters(world, "barn_dispersion", 2021), parameters(world, "barn_dispersion", 2020));
  EXPECT_NE(parameters(world, "barn_visibility", 2021), parameters(world, "barn_visibility", 2020));
}

}  // namespace
}  // namespace slalom
