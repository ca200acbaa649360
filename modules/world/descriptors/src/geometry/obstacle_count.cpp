// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/descriptors/descriptor.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <vector>

namespace slalom::descriptors {
namespace {

/// Occupied cells first..last of a row, whose neighbors in it are free.
struct Run {
  int row, first, last;
};

std::vector<Run> occupied_runs(const Occupancy& cells) {
  std::vector<Run> runs;
  for (int row = 0; row < cells.size_y(); ++row) {
    const std::uint8_t* const begin = cells.cells().data() + cells.index(0, row);
    const std::uint8_t* const end = begin + cells.size_x();
    for (const std::uint8_t* first = std::find(begin, end, 1); first != end;) {
      const std::uint8_t* const past = std::find(first, end, 0);
      runs.push_back({row, static_cast<int>(first - begin), static_cast<int>(past - begin) - 1});
      first = std::find(past, end, 1);
    }
  }
  return runs;
}

}  // namespace

/// Number of 8-connected components of O that do not touch the border.
Value obstacle_count(const DescriptorContext& context) {
  const Occupancy& cells = context.world.occupancy();
  const std::vector<Run> runs = occupied_runs(cells);
  const std::size_t border = runs.size();
  boost::disjoint_sets_with_storage<> joined(runs.size() + 1);
  std::size_t below = 0;  // the first run of the row below that is not left of the present one
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto [row, first, last] = runs[i];
    if (row == 0 || first == 0 || row == cells.size_y() - 1 || last == cells.size_x() - 1)
      joined.union_set(i, border);
    while (runs[below].row < row - 1 || (runs[below].row < row && runs[below].last < first - 1))
      ++below;
    for (std::size_t j = below; runs[j].row < row && runs[j].first <= last + 1; ++j)
      joined.union_set(i, j);
  }
  std::size_t components = 0;  // without that of the border
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (joined.find_set(i) == i && joined.find_set(border) != i) ++components;
  return Value::of(static_cast<double>(components));
}

}  // namespace slalom::descriptors
