#include <slalom/studio/list_lines.h>
#include <slalom/studio/list_view.h>

#include <algorithm>

namespace slalom {

ListLines::ListLines(std::size_t scenarios, const std::vector<ListGroup>& groups,
                     const std::set<std::string>& closed_titles) {
  for (const ListGroup& group : groups) {
    const bool closed = closed_titles.count(group.title) > 0;
    groups_.push_back({size_, group.first, group.count, closed});
    size_ += 1 + (closed ? 0 : group.count);
  }
  if (groups.empty()) size_ = scenarios;
}

ListLines::Line ListLines::at(std::size_t line) const {
  if (groups_.empty()) return {std::nullopt, line};
  const auto after = std::upper_bound(groups_.begin(), groups_.end(), line,
                                      [](std::size_t l, const Group& g) { return l < g.header; });
  const Group& group = *(after - 1);
  if (line == group.header) return {static_cast<std::size_t>(after - 1 - groups_.begin()), 0};
  return {std::nullopt, group.first + (line - group.header - 1)};
}

std::optional<std::size_t> ListLines::group_of(std::size_t index) const {
  const auto after = std::upper_bound(groups_.begin(), groups_.end(), index,
                                      [](std::size_t p, const Group& g) { return p < g.first; });
  if (after == groups_.begin()) return std::nullopt;
  return static_cast<std::size_t>(after - 1 - groups_.begin());
}

std::optional<std::size_t> ListLines::line_of(std::size_t index) const {
  if (groups_.empty()) return index < size_ ? std::make_optional(index) : std::nullopt;
  const auto number = group_of(index);
  if (!number) return std::nullopt;
  const Group& group = groups_[*number];
  if (group.closed || index - group.first >= group.count) return std::nullopt;
  return group.header + 1 + (index - group.first);
}

double ListLines::top_of(std::size_t line, const Heights& heights) const {
  const auto after = std::lower_bound(groups_.begin(), groups_.end(), line,
                                      [](const Group& g, std::size_t l) { return g.header < l; });
  const auto headers = static_cast<std::size_t>(after - groups_.begin());
  return static_cast<double>(headers) * heights.group +
         static_cast<double>(line - headers) * heights.scenario;
}

std::size_t ListLines::line_at(double y, const Heights& heights) const {
  std::size_t low = 0, high = size_;
  while (low + 1 < high) {
    const std::size_t middle = low + (high - low) / 2;
    (top_of(middle, heights) <= y ? low : high) = middle;
  }
  return low;
}

}  // namespace slalom
