#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace slalom {

struct ListGroup;

/// The lines of a list from top to bottom: one for each scenario, or, with groups, one for each
/// group and below it one for each of its scenarios unless it is closed.
class ListLines {
 public:
  struct Line {
    std::optional<std::size_t> group;  ///< the line is the head of this group
    std::size_t place = 0;             ///< else: of the scenario in the view
  };

  ListLines() = default;
  ListLines(std::size_t scenarios, const std::vector<ListGroup>& groups,
            const std::set<std::string>& closed_titles);

  std::size_t size() const { return size_; }
  Line at(std::size_t line) const;  ///< requires line < size()
  /// None when the scenario's group is closed.
  std::optional<std::size_t> line_of(std::size_t place) const;
  std::size_t line_of_group(std::size_t group) const { return groups_[group].head; }
  bool is_closed(std::size_t group) const { return groups_[group].closed; }
  std::optional<std::size_t> group_of(std::size_t place) const;  ///< none without groups

  /// How high lines are drawn (pixels).
  struct Heights {
    double scenario, group;
  };
  /// Where a line begins below the first one; of size() where the last one ends.
  double top_of(std::size_t line, const Heights& heights) const;
  /// The line there, the first or last one beyond; requires size() > 0.
  std::size_t line_at(double y, const Heights& heights) const;

 private:
  struct Group {
    std::size_t head;          ///< line of its head
    std::size_t first, count;  ///< places of its scenarios
    bool closed;
  };
  std::vector<Group> groups_;
  std::size_t size_ = 0;
};

}  // namespace slalom
