// SPDX-License-Identifier: BSD-3-Clause
#include "walls.h"

#include <boost/pending/disjoint_sets.hpp>

#include <cmath>
#include <cstddef>
#include <numeric>

namespace slalom {
namespace {

/// 0 ... count - 1 in random order.
std::vector<std::size_t> shuffled(RandomEngine& engine, std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1],
              order[static_cast<std::size_t>(uniform_int(engine, 0, static_cast<int>(i) - 1))]);
  return order;
}

}  // namespace

Polygon rectangle(double x_min, double y_min, double x_max, double y_max) {
  return {{{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}}};
}

std::vector<bool> open_walls(RandomEngine& engine, int cells, const std::vector<CellPair>& walls,
                             double extra_fraction) {
  boost::disjoint_sets_with_storage<> joined(static_cast<std::size_t>(cells));
  for (int i = 0; i < cells; ++i) joined.make_set(i);
  std::vector<bool> open(walls.size(), false);
  std::vector<std::size_t> rest;
  for (const std::size_t i : shuffled(engine, walls.size())) {
    const auto a = joined.find_set(walls[i].first), b = joined.find_set(walls[i].second);
    if (a == b) {
      rest.push_back(i);
    } else {
      joined.link(a, b);
      open[i] = true;
    }
  }
  const auto loops = static_cast<std::size_t>(std::lround(extra_fraction * double(rest.size())));
  for (std::size_t i = 0; i < loops; ++i) open[rest[i]] = true;
  return open;
}

}  // namespace slalom
