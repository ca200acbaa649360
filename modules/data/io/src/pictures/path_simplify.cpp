// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/io/path_simplify.h>

#include <utility>

namespace slalom {
namespace {

using Span = std::pair<std::size_t, std::size_t>;

/// The inner vertex of the span that is farthest from the segment between its ends.
std::pair<std::size_t, double> farthest_vertex(const Path& path, const Span& span) {
  const Path chord = {path[span.first], path[span.second]};
  std::size_t farthest = span.first;
  double largest = 0;
  for (std::size_t i = span.first + 1; i < span.second; ++i) {
    const double distance = distance_to_path(path[i], chord);
    if (distance <= largest) continue;
    largest = distance;
    farthest = i;
  }
  return {farthest, largest};
}

}  // namespace

Path simplify(const Path& path, double tolerance) {
  if (path.size() < 3) return path;
  std::vector<bool> keep(path.size(), false);
  keep.front() = keep.back() = true;
  std::vector<Span> open = {{0, path.size() - 1}};
  while (!open.empty()) {
    const Span span = open.back();
    open.pop_back();
    const auto [vertex, distance] = farthest_vertex(path, span);
    if (distance <= tolerance) continue;
    keep[vertex] = true;
    open.push_back({span.first, vertex});
    open.push_back({vertex, span.second});
  }
  Path simple;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (keep[i]) simple.push_back(path[i]);
  }
  return simple;
}

}  // namespace slalom
