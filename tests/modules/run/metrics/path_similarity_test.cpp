// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <slalom/core/random.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

double distance(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Discrete Frechet distance (Eiter and Mannila 1994).
double discrete_frechet(const Path& a, const Path& b) {
  std::vector<double> row(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    double diagonal = row[0];
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double above = row[j], here = distance(a[i], b[j]);
      double distance_here = here;
      if (i > 0 && j > 0) distance_here = std::max(here, std::min({above, diagonal, row[j - 1]}));
      if (i > 0 && j == 0) distance_here = std::max(here, above);
      if (i == 0 && j > 0) distance_here = std::max(here, row[j - 1]);
      row[j] = distance_here;
      diagonal = above;
    }
  }
  return row.back();
}

double sampled_hausdorff(const Path& a, const Path& b) {
  double farthest = 0;
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
    for (const auto& p : from) farthest = std::max(farthest, distance_to_path(p, to));
  return farthest;
}

Path random_path(RandomEngine& random, int pieces) {
  Path path;
  for (int i = 0; i <= pieces; ++i)
    path.emplace_back(uniform_real(random, 1, 9), uniform_real(random, 1, 9));
  return path;
}

/// A path from (2, 5) to (8, 5) close to the straight line, like typical runs and references.
Path random_run_path(RandomEngine& random, int pieces) {
  Path path = {{2, 5}};
  for (int i = 1; i < pieces; ++i)
    path.emplace_back(2 + 6.0 * i / pieces, 5 + uniform_real(random, -1, 1));
  path.emplace_back(8, 5);
  return path;
}

void expect_brute_force(const Path& traveled, const Path& reference) {
  MeasuredRun run(traveled);
  run.set_shortest(reference);
  constexpr double kSpacing = 0.02;
  const Path a = resample(traveled, kSpacing), b = resample(reference, kSpacing);
  // The discrete distance is at most the spacing above; the sampled one at most half of it below.
  const double frechet = run.number("frechet_to_reference"), discrete = discrete_frechet(a, b);
  EXPECT_LE(frechet, discrete + 2e-6);
  EXPECT_GE(frechet, discrete - kSpacing);
  const double hausdorff = run.number("hausdorff_to_reference");
  EXPECT_LE(hausdorff, sampled_hausdorff(a, b) + 0.5 * kSpacing);
  EXPECT_GE(hausdorff, sampled_hausdorff(a, b) - 2e-6);
  EXPECT_GE(frechet, hausdorff - 1e-9);
}

TEST(PathSimilarity, AgreesWithBruteForce) {
  RandomEngine random(4);
  for (int i = 0; i < 40; ++i) {
    expect_brute_force(random_path(random, uniform_int(random, 1, 5)),
                       random_path(random, uniform_int(random, 1, 5)));
    expect_brute_force(random_run_path(random, uniform_int(random, 1, 30)),
                       random_run_path(random, uniform_int(random, 1, 30)));
  }
}

TEST(PathSimilarity, IsZeroOnTheShortestPathForAnySampling) {
  const MeasuredRun run({{2, 5}, {2.7, 5}, {5, 5}, {8, 5}});
  EXPECT_NEAR(run.number("frechet_to_reference"), 0, 1e-5);
  EXPECT_NEAR(run.number("hausdorff_to_reference"), 0, 1e-6);
}

TEST(PathSimilarity, OfAParallelLineIsItsDistance) {
  const MeasuredRun run({{2, 4}, {5, 4}, {8, 4}});
  EXPECT_NEAR(run.number("frechet_to_reference"), 1, 1e-5);
  EXPECT_NEAR(run.number("hausdorff_to_reference"), 1, 1e-6);
}

TEST(FrechetToReference, DetectsBacktrackingUnlikeTheHausdorffDistance) {
  // To x = 7, back to x = 3, then to the goal: during the 4 m back the best match on the reference
  // is x = 5.
  const MeasuredRun run({{2, 5}, {7, 5}, {3, 5}, {8, 5}});
  EXPECT_NEAR(run.number("frechet_to_reference"), 2, 1e-5);
  EXPECT_NEAR(run.number("hausdorff_to_reference"), 0, 1e-6);
}

TEST(HausdorffToReference, IsSymmetric) {
  // The traveled path lies on the reference, but omits its detour.
  MeasuredRun run({{2, 5}, {8, 5}});
  run.set_shortest({{2, 5}, {5, 5}, {5, 7}, {5, 5}, {8, 5}});
  EXPECT_NEAR(run.number("hausdorff_to_reference"), 2, 1e-6);
}

TEST(HausdorffToReference, FindsTheMaximumBetweenVertices) {
  // From the middle of the traveled line both ends of the reference are 3 m away, its top 4 m.
  MeasuredRun run({{2, 5}, {8, 5}});
  run.set_shortest({{2, 5}, {2, 9}, {8, 9}, {8, 5}});
  EXPECT_NEAR(run.number("hausdorff_to_reference"), 4, 1e-6);
  // Here the middle of the traveled line is 3 m from the reference.
  run.set_shortest({{2, 5}, {2, 8}, {8, 8}, {8, 5}});
  EXPECT_NEAR(run.number("hausdorff_to_reference"), 3, 1e-6);
}

TEST(PathSimilarity, OfSinglePointsIsTheirDistance) {
  MeasuredRun run({{8, 5}});
  run.set_shortest({{8, 5.5}});
  EXPECT_NEAR(run.number("frechet_to_reference"), 0.5, 1e-6);
  EXPECT_NEAR(run.number("hausdorff_to_reference"), 0.5, 1e-6);
}

}  // namespace
}  // namespace slalom::testing
