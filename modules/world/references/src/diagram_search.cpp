// SPDX-License-Identifier: BSD-3-Clause
#include "diagram.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace slalom {
namespace {

/// Lengths of paths in multiples of 2^-24 cells: sums are exact, so that the cost of a path does
/// not depend on the order of its steps, and equal costs are equal.
using Length = std::int64_t;
constexpr int kFractionBits = 24;
constexpr Length kStraight = Length{1} << kFractionBits;
constexpr Length kExactDiagonal = 23726566;  // sqrt(2)
constexpr Length kNotReached = std::numeric_limits<Length>::max();

/// Octile distance: the length of the shortest 8-connected path without obstacles.
Length octile(const GridCell& a, const GridCell& b) {
  const Length dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  return kStraight * std::max(dx, dy) + (kExactDiagonal - kStraight) * std::min(dx, dy);
}

constexpr std::size_t kStepCount = std::size(kSteps);
/// Instead of the step by which a cell was entered.
constexpr std::size_t kAnyStep = kStepCount;

struct Entry {
  Length cost;
  GridCell at;
  std::size_t entered_by;
};

/// Whether to go on by `next` from a cell off the diagram that was entered by `last`. Otherwise the
/// cell before is a neighbor of the next one, or the same: going there directly is cheaper,
/// whatever the next cell costs, as entering this one costs the most.
constexpr bool goes_on(const Step& last, const Step& next) {
  const int dx = last.dx + next.dx, dy = last.dy + next.dy;
  return dx < -1 || dx > 1 || dy < -1 || dy > 1;
}

/// The steps that may follow each step, in the order of kSteps.
struct Continuations {
  std::array<std::size_t, kStepCount + 1> count{};
  std::array<std::array<std::uint8_t, kStepCount>, kStepCount + 1> steps{};
};

constexpr Continuations make_continuations() {
  Continuations result;
  for (std::size_t last = 0; last <= kStepCount; ++last)
    for (std::size_t next = 0; next < kStepCount; ++next)
      if (last == kAnyStep || goes_on(kSteps[last], kSteps[next]))
        result.steps[last][result.count[last]++] = static_cast<std::uint8_t>(next);
  return result;
}

constexpr Continuations kContinuations = make_continuations();

/// Entries in buckets of estimates, one cell wide and unsorted: the costs that the search ends with
/// do not depend on the order.
class BucketQueue {
 public:
  explicit BucketQueue(Length least) : least_(least) {}

  /// `estimate` is not below that of the entry popped last, as octile distances are consistent.
  void push(Length estimate, const Entry& entry) {
    const auto bucket = static_cast<std::size_t>((estimate - least_) >> kFractionBits);
    if (bucket >= buckets_.size()) buckets_.resize(std::max(bucket + 1, 2 * buckets_.size()));
    buckets_[bucket].push_back(entry);
  }

  /// Takes an entry of the first bucket, if that may hold estimates of at most `most`.
  bool pop(Length most, Entry& entry) {
    while (first_ < buckets_.size() && buckets_[first_].empty()) ++first_;
    if (first_ >= buckets_.size() || (most - least_) >> kFractionBits < static_cast<Length>(first_))
      return false;
    entry = buckets_[first_].back();
    buckets_[first_].pop_back();
    return true;
  }

 private:
  Length least_;
  std::size_t first_ = 0;
  std::vector<std::vector<Entry>> buckets_;
};

}  // namespace

inline Length Diagram::cost_of(const Step& step, std::size_t to) const {
  const Length length = step.dx != 0 && step.dy != 0 ? kExactDiagonal : kStraight;
  return kinds_[to] == Kind::Ridge ? length : kOffDiagramCost * length;
}

std::vector<Length> Diagram::costs(const GridCell& from, const GridCell& to) const {
  std::vector<Length> cost(kinds_.size(), kNotReached);
  BucketQueue queue(octile(from, to));
  cost[index(from.x, from.y)] = 0;
  queue.push(octile(from, to), {0, from, kAnyStep});
  const Length& least = cost[index(to.x, to.y)];
  Entry entry{};
  while (queue.pop(least, entry)) {
    const std::size_t at = index(entry.at.x, entry.at.y);
    if (entry.cost > cost[at]) continue;
    const std::size_t last =
        corners_clear_ && kinds_[at] == Kind::Wide ? entry.entered_by : kAnyStep;
    for (std::size_t i = 0; i < kContinuations.count[last]; ++i) {
      const std::size_t by = kContinuations.steps[last][i];
      const Step& step = kSteps[by];
      const std::size_t next = neighbor(at, step.dx, step.dy);
      if (kinds_[next] < Kind::Wide) continue;
      const Length total = entry.cost + cost_of(step, next);
      if (total >= cost[next] || cuts_corner(at, step)) continue;
      cost[next] = total;
      const GridCell cell{entry.at.x + step.dx, entry.at.y + step.dy};
      queue.push(total + octile(cell, to), {total, cell, by});
    }
  }
  return cost;
}

GridCell Diagram::predecessor(const GridCell& at, const std::vector<Length>& cost) const {
  const std::size_t here = index(at.x, at.y);
  GridCell best = at;
  double clearance = -1;
  for (const Step& step : kSteps) {
    const GridCell cell{at.x - step.dx, at.y - step.dy};
    const std::size_t before = index(cell.x, cell.y);
    if (kinds_[before] < Kind::Wide || cuts_corner(before, step)) continue;
    if (cost[before] != cost[here] - cost_of(step, here) || d(cell.x, cell.y) <= clearance)
      continue;
    best = cell;
    clearance = d(cell.x, cell.y);
  }
  return best;
}

std::vector<GridCell> Diagram::shortest(const GridCell& from, const GridCell& to) const {
  const std::vector<Length> cost = costs(from, to);
  if (cost[index(to.x, to.y)] == kNotReached) return {};
  std::vector<GridCell> path = {to};
  while (!(path.back() == from)) path.push_back(predecessor(path.back(), cost));
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace slalom
