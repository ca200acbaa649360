#pragma once

#include <slalom/scenario/selection.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Under which key a list keeps the values of one descriptor.
struct DescriptorKey {
  std::string id;
  int version = 1;
  /// "robot_radius=0.25;resolution=0.05"; a '*' stands for anything, where they differ from
  /// scenario to scenario
  std::string parameters;
};

/// For each descriptor that is spoken of the keys of its values. More than one where the key
/// depends on the kind of scenario: grids have a resolution of their own.
using DescriptorView = std::map<std::string, std::vector<DescriptorKey>>;

/// Which scenarios of a list, and in what order. The empty selection is the whole list.
struct ListSelection {
  SelectionPtr where;                              ///< none: all
  std::optional<std::vector<std::string>> hashes;  ///< none: all
  std::vector<SelectionOrder> order;               ///< before the order of the list; NA comes last
  std::optional<std::size_t> limit;                ///< at most so many
  DescriptorView view;                             ///< of the fields with numbers
};

/// An index of a list: finds scenarios by a descriptor quickly, and cuts its values into ranges.
struct ListIndex {
  std::string name;        ///< a word
  std::string descriptor;  ///< id
  std::vector<DescriptorKey> keys;
  std::vector<double> edges;  ///< increasing; [e0, e1), [e1, e2), ..., the last range is closed

  std::size_t ranges() const { return edges.size() - 1; }
};

/// How many scenarios each range of an index holds.
struct ListIndexCounts {
  std::vector<std::size_t> ranges;
  std::size_t below = 0, above = 0;  ///< the first and the last edge
  std::size_t na = 0;                ///< the value is NA
  std::size_t unknown = 0;           ///< never computed
};

/// What an action did to a list, so that it can be taken back and done again.
class ListChange {
 public:
  ListChange() = default;
  explicit ListChange(std::string bytes) : bytes_(std::move(bytes)) {}
  bool empty() const { return bytes_.empty(); }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;  ///< a changeset of SQLite's session extension
};

}  // namespace slalom
