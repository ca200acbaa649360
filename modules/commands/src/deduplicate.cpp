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

using Point = std::vector<std::optional<double>>;  ///< in units of the least differences
using Cell = std::vector<std::int64_t>;

constexpr std::size_t kMostDescriptors = 6;  ///< 729 cells to look at for each scenario
constexpr std::int64_t kNaCell = INT64_MIN;

bool alike(const Point& a, const Point& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].has_value() != b[i].has_value()) return false;
    if (a[i] && std::abs(*a[i] - *b[i]) >= 1) return false;
  }
  return true;
}

/// Points in cells of one least difference: what is alike lies in the same cell or one beside it.
class KeptPoints {
 public:
  /// False when one that is alike is there; else it is kept.
  bool keep(const Point& point) {
    Cell cell(point.size(), kNaCell);
    for (std::size_t i = 0; i < point.size(); ++i)
      if (point[i]) cell[i] = std::llround(std::floor(std::clamp(*point[i], -4e15, 4e15)));
    if (any_alike(point, cell, 0)) return false;
    cells_[cell].push_back(point);
    return true;
  }

 private:
  bool any_alike(const Point& point, Cell& cell, std::size_t from) const {
    if (from == cell.size()) {
      const auto there = cells_.find(cell);
      return there != cells_.end() &&
             std::any_of(there->second.begin(), there->second.end(),
                         [&](const Point& other) { return alike(point, other); });
    }
    const std::int64_t here = cell[from];
    bool found = any_alike(point, cell, from + 1);
    for (const std::int64_t step : {-1, 1}) {
      if (found || here == kNaCell) break;
      cell[from] = here + step;
      found = any_alike(point, cell, from + 1);
    }
    cell[from] = here;
    return found;
  }

  std::map<Cell, std::vector<Point>> cells_;
};

}  // namespace

ListCommandPtr make_deduplicate(ScenarioList& list, DescriptorView view,
                                std::vector<std::pair<std::string, double>> least_differences) {
  if (least_differences.size() > kMostDescriptors)
    throw usage_error("least differences", "of too many descriptors",
                      std::to_string(kMostDescriptors) + " at most");
  for (const auto& [id, difference] : least_differences)
    if (!(difference > 0))
      throw usage_error("least difference of " + id, format_number(difference) + " is none", "> 0");
  KeptPoints kept;
  ListSelection surplus;
  surplus.hashes.emplace();
  if (!least_differences.empty())
    list.for_each({}, [&](const ScenarioList::Entry& entry) {
      Point point;
      for (const auto& [id, difference] : least_differences) {
        const auto value = list.find(entry.hash, view.at(id));
        point.push_back(value && !value->is_na() ? std::make_optional(value->number() / difference)
                                                 : std::nullopt);
      }
      if (!kept.keep(point)) surplus.hashes->push_back(entry.hash);
      return true;
    });
  const std::size_t count = surplus.hashes->size();
  return std::make_unique<RecordedCommand>(
      std::vector<ScenarioList*>{&list}, "Leave out " + scenarios_text(count) + " like others",
      [&list, surplus] { list.remove(surplus); },
      [count] { return std::string(count == 0 ? "no scenarios are alike" : ""); });
}

}  // namespace slalom
