#include "string_pulling.h"

#include <slalom/references/reference.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

class StringPuller {
 public:
  StringPuller(const World& world, double radius) : world_(world), radius_(radius) {}

  /// Connects each vertex to the farthest following one reachable on a free straight line.
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

  /// Replaces each inner vertex by the two ends of the largest free corner cut.
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

  /// As a fraction of both sides; at most 0.5, so that adjacent cuts never overlap.
  double largest_cut(const TPoint2D& before, const TPoint2D& corner, const TPoint2D& after) const {
    const auto cut_is_free = [&](double fraction) {
      return is_straight_free(corner + (before - corner) * fraction,
                              corner + (after - corner) * fraction);
    };
    constexpr double kMaxCut = 0.5;
    if (cut_is_free(kMaxCut)) return kMaxCut;
    double low = 0, high = kMaxCut;
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

Path pull_string(const World& world, Path path, double radius) {
  if (path.size() < 3) return path;
  const StringPuller tightener(world, radius);
  constexpr int kRounds = 4;  // each quarters the remaining excess length at a corner
  path = tightener.shortcut(path);
  for (int round = 0; round < kRounds; ++round)
    path = tightener.shortcut(tightener.cut_corners(path));
  return path;
}

}  // namespace slalom
