#include "taut.h"

#include <slalom/references/reference.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

class Tightener {
 public:
  Tightener(const World& world, double radius) : world_(world), radius_(radius) {}

  /// Goes from each vertex to the farthest of those after it that it can reach straight.
  Path shortcut(const Path& path) const {
    Path result = {path.front()};
    for (std::size_t i = 0; i + 1 < path.size();) {
      std::size_t next = i + 1;
      for (std::size_t j = i + 2; j < path.size() && is_straight_free(path[i], path[j]); ++j)
        next = j;
      result.push_back(path[next]);
      i = next;
    }
    return result;
  }

  /// Replaces each inner vertex by the two ends of the largest cut across it that is free.
  Path cut_corners(const Path& path) const {
    Path result = {path.front()};
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const TPoint2D before = path[i - 1], corner = path[i], after = path[i + 1];
      const double cut = largest_cut(before, corner, after);
      result.push_back(corner + (before - corner) * cut);
      result.push_back(corner + (after - corner) * cut);
    }
    result.push_back(path.back());
    return result;
  }

 private:
  bool is_straight_free(const TPoint2D& a, const TPoint2D& b) const {
    return is_free(world_, {a, b}, radius_);
  }

  /// As a share of both sides; at most a half, so that neighbouring cuts never overlap.
  double largest_cut(const TPoint2D& before, const TPoint2D& corner, const TPoint2D& after) const {
    const auto cut_is_free = [&](double share) {
      return is_straight_free(corner + (before - corner) * share,
                              corner + (after - corner) * share);
    };
    constexpr double kMost = 0.5;
    if (cut_is_free(kMost)) return kMost;
    double low = 0, high = kMost;
    for (int i = 0; i < 12; ++i) {
      const double middle = 0.5 * (low + high);
      (cut_is_free(middle) ? low : high) = middle;
    }
    return low;
  }

  const World& world_;
  double radius_;
};

}  // namespace

Path pull_taut(const World& world, Path path, double radius) {
  if (path.size() < 3) return path;
  const Tightener tightener(world, radius);
  constexpr int kRounds = 4;  // each quarters what is left to gain at a corner
  path = tightener.shortcut(path);
  for (int round = 0; round < kRounds; ++round)
    path = tightener.shortcut(tightener.cut_corners(path));
  return path;
}

}  // namespace slalom
