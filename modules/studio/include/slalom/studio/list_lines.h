#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace slalom {

struct ListGroup;

/// The lines of a list from top to bottom: one per scenario, or with groups a header line per
/// group, followed by the scenarios of the group unless it is closed.
class ListLines {
 public:
  struct Line {
    std::optional<std::size_t> group;  ///< of a group header
    std::size_t index = 0;             ///< else: of the scenario in the view
  };

  ListLines() = default;
  ListLines(std::size_t scenarios, const std::vector<ListGroup>& groups,
            const std::set<std::string>& closed_titles);

  std::size_t size() const { return size_; }
  Line at(std::size_t line) const;  ///< requires line < size()
  /// None if the group of the scenario is closed.
  std::optional<std::size_t> line_of(std::size_t index) const;
  std::size_t line_of_group(std::size_t group) const { return groups_[group].header; }
  bool is_closed(std::size_t group) const { return groups_[group].closed; }
  std::optional<std::size_t> group_of(std::size_t index) const;  ///< none without groups

  /// Line heights (pixels).
  struct Heights {
    double scenario, group;
  };
  /// Offset (pixels) of the top of a line; of size(): the total height.
  double top_of(std::size_t line, const Heights& heights) const;
  /// The line at offset `y`, clamped to the first and last line; requires size() > 0.
  std::size_t line_at(double y, const Heights& heights) const;

 private:
  struct Group {
    std::size_t header;        ///< line of the header
    std::size_t first, count;  ///< range of its scenarios in the view
    bool closed;
  };
  std::vector<Group> groups_;
  std::size_t size_ = 0;
};

}  // namespace slalom
