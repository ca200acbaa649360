// SPDX-License-Identifier: BSD-3-Clause
#include "connection.h"

#include <array>

namespace slalom::disc_path {
namespace {

/// Fills runs of open cells from two points; each run knows which fill reached it first.
class TwoFills {
 public:
  explicit TwoFills(const OpenRows& open) : open_(open) {}

  void begin(int fill, const Run* run, int y) {
    owner(run, y) = marked(fill);
    fronts_[fill].push_back({run, y});
  }

  bool is_done(int fill) const { return fronts_[fill].empty(); }

  /// Goes on from one run to those that touch it. True if the other fill has reached one of them.
  bool meets_the_other(int fill) {
    const auto [run, y] = fronts_[fill].back();
    fronts_[fill].pop_back();
    for (const int next_y : {y - 1, y + 1}) {
      const std::vector<Run>& row = open_.runs(next_y);
      auto next = open_.first_after(run->first - 1, next_y);
      for (; next != row.end() && next->first <= run->last; ++next) {
        char& reached_by = owner(&*next, next_y);
        if (reached_by == marked(1 - fill)) return true;
        if (reached_by == 0) fronts_[fill].push_back({&*next, next_y});
        reached_by = marked(fill);
      }
    }
    return false;
  }

 private:
  static char marked(int fill) { return static_cast<char>(1 + fill); }

  /// 0 if no fill has reached the run.
  char& owner(const Run* run, int y) {
    const auto row = static_cast<std::size_t>(y);
    if (row >= owners_.size()) owners_.resize(row + 1);
    const std::vector<Run>& runs = open_.runs(y);
    owners_[row].resize(runs.size());
    return owners_[row][static_cast<std::size_t>(run - runs.data())];
  }

  const OpenRows& open_;
  std::vector<std::vector<char>> owners_;  ///< by row and run
  std::array<std::vector<std::pair<const Run*, int>>, 2> fronts_;
};

}  // namespace

bool may_connect(const OpenRows& open, const Vector& start, const Vector& goal) {
  const auto row_of = [](const Vector& p) { return static_cast<int>(std::floor(p.y)); };
  const auto run_of = [&](const Vector& p) {
    return open.find(static_cast<int>(std::floor(p.x)), row_of(p));
  };
  const Run* first = run_of(start);
  const Run* last = run_of(goal);
  // A free point on the edge of the map, or by rounding: nothing is proved.
  if (first == nullptr || last == nullptr || first == last) return true;
  TwoFills fills(open);
  fills.begin(0, first, row_of(start));
  fills.begin(1, last, row_of(goal));
  while (!fills.is_done(0) && !fills.is_done(1))
    if (fills.meets_the_other(0) || fills.meets_the_other(1)) return true;
  return false;
}

}  // namespace slalom::disc_path
