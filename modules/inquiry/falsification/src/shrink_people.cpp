// SPDX-License-Identifier: BSD-3-Clause
#include "shrinker.h"

#include <algorithm>
#include <array>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

using Route = std::vector<TPoint2D>;

bool replace_route(Shrinker& shrinker, std::size_t person, Route route) {
  return shrinker.accept([&] {
    People people = shrinker.scenario().people();
    people[person].route = std::move(route);
    return shrinker.scenario().with_people(std::move(people));
  });
}

/// Leaves out via points, the last ones first.
bool drop_via_points(Shrinker& shrinker, std::size_t person) {
  bool changed = false;
  for (std::size_t i = shrinker.scenario().people()[person].route.size() - 1; i-- > 0;) {
    Route route = shrinker.scenario().people()[person].route;
    route.erase(route.begin() + static_cast<std::ptrdiff_t>(i));
    changed |= replace_route(shrinker, person, std::move(route));
  }
  return changed;
}

/// Moves the goal towards the point before it.
bool move_goal_nearer(Shrinker& shrinker, std::size_t person) {
  constexpr std::array kFractions = {0.3, 0.5, 0.7, 0.85};
  constexpr double kShortest = 0.5;  // m; a person whose way is shorter hardly walks
  const Person one = shrinker.scenario().people()[person];
  const TPoint2D from = one.route.size() > 1 ? one.route[one.route.size() - 2] : one.start;
  const TPoint2D way = one.route.back() - from;
  return std::any_of(kFractions.begin(), kFractions.end(), [&](double fraction) {
    if (way.norm() * fraction < kShortest) return false;
    Route route = one.route;
    route.back() = from + way * fraction;
    return replace_route(shrinker, person, std::move(route));
  });
}

}  // namespace

bool shorten_routes(Shrinker& shrinker) {
  bool changed = false;
  for (std::size_t i = 0; i < shrinker.scenario().people().size(); ++i) {
    changed |= drop_via_points(shrinker, i);
    changed |= move_goal_nearer(shrinker, i);
  }
  return changed;
}

}  // namespace slalom
