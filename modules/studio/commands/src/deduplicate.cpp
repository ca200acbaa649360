// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_command.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace slalom {
namespace {

using Point = std::vector<std::optional<double>>;  ///< in units of the minimum differences
using Cell = std::vector<std::int64_t>;

constexpr std::size_t kMaxDescriptors = 6;  ///< 729 cells are searched for each scenario
constexpr std::int64_t kNaCell = INT64_MIN;

bool are_near_duplicates(const Point& a, const Point& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].has_value() != b[i].has_value()) return false;
    if (a[i] && std::abs(*a[i] - *b[i]) >= 1) return false;
  }
  return true;
}

/// Points in a grid whose cell size is the minimum difference: near-duplicates are in the same cell
/// or in an adjacent one.
class KeptPoints {
 public:
  /// Adds the point and returns true, unless a near-duplicate was added before.
  bool keep(const Point& point) {
    Cell cell(point.size(), kNaCell);
    for (std::size_t i = 0; i < point.size(); ++i)
      if (point[i]) cell[i] = std::llround(std::floor(std::clamp(*point[i], -4e15, 4e15)));
    if (any_near_duplicate(point, cell, 0)) return false;
    cells_[cell].push_back(point);
    return true;
  }

 private:
  bool any_near_duplicate(const Point& point, Cell& cell, std::size_t from) const {
    if (from == cell.size()) {
      const auto found = cells_.find(cell);
      return found != cells_.end() &&
             std::any_of(found->second.begin(), found->second.end(),
                         [&](const Point& other) { return are_near_duplicates(point, other); });
    }
    const std::int64_t center = cell[from];
    bool found = any_near_duplicate(point, cell, from + 1);
    for (const std::int64_t step : {-1, 1}) {
      if (found || center == kNaCell) break;
      cell[from] = center + step;
      found = any_near_duplicate(point, cell, from + 1);
    }
    cell[from] = center;
    return found;
  }

  std::map<Cell, std::vector<Point>> cells_;
};

}  // namespace

ListCommandPtr make_deduplicate(ScenarioList& list, DescriptorView view,
                                std::vector<std::pair<std::string, double>> min_differences) {
  if (min_differences.size() > kMaxDescriptors)
    throw usage_error("minimum differences", "too many descriptors",
                      "at most " + std::to_string(kMaxDescriptors));
  for (const auto& [id, difference] : min_differences)
    if (!(difference > 0))
      throw usage_error("minimum difference of " + id, "invalid value " + format_number(difference),
                        "> 0");
  KeptPoints kept;
  ListSelection duplicates;
  duplicates.hashes.emplace();
  if (!min_differences.empty())
    list.for_each({}, [&](const ScenarioList::Entry& entry) {
      Point point;
      for (const auto& [id, difference] : min_differences) {
        const auto value = list.find(entry.hash, view.at(id));
        point.push_back(value && !value->is_na() ? std::make_optional(value->number() / difference)
                                                 : std::nullopt);
      }
      if (!kept.keep(point)) duplicates.hashes->push_back(entry.hash);
      return true;
    });
  const std::size_t count = duplicates.hashes->size();
  return std::make_unique<RecordedCommand>(
      std::vector<ScenarioList*>{&list}, "Remove " + scenarios_text(count) + " as near-duplicates",
      [&list, duplicates] { list.remove(duplicates); },
      [count] { return std::string(count == 0 ? "no near-duplicates found" : ""); });
}

}  // namespace slalom
