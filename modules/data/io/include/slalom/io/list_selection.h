// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>
#include <slalom/scenario/selection.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace slalom {

/// The keys of the values of each used descriptor. Several keys if they depend on the kind of
/// scenario: grids have their own resolution. In the parameters a '*' is a wildcard for what
/// differs between scenarios.
using DescriptorView = std::map<std::string, std::vector<ValueKey>>;

/// The values of a field that is not stored in the list, such as a result of runs, by the hash of a
/// scenario. A scenario without a value is NA.
struct ListField {
  bool is_text = false;
  std::string unit = "-";
  std::map<std::string, Value> numbers;
  /// All texts of a scenario; a condition is fulfilled if it is by one of them.
  std::map<std::string, std::set<std::string>> texts;
};

/// A subset of a list and its order. The default selection is the complete list.
struct ListSelection {
  SelectionPtr where;                              ///< none: all
  std::optional<std::vector<std::string>> hashes;  ///< none: all
  std::vector<SelectionOrder> order;               ///< NA last; ties in list order
  std::optional<std::size_t> limit;                ///< maximum number of scenarios
  DescriptorView view;                             ///< keys of the descriptors
  std::map<std::string, std::shared_ptr<const ListField>> fields = {};  ///< others, by name
};

/// An index of a list: speeds up selections by a descriptor and divides its values into ranges.
struct ListIndex {
  std::string name;        ///< an identifier
  std::string descriptor;  ///< id
  std::vector<ValueKey> keys;
  std::vector<double> edges;  ///< increasing; [e0, e1), [e1, e2), ..., the last range is closed

  std::size_t ranges() const { return edges.size() - 1; }
};

/// The number of scenarios in each range of an index.
struct ListIndexCounts {
  std::vector<std::size_t> ranges;
  std::size_t below = 0, above = 0;  ///< below the first or above the last edge
  std::size_t na = 0;                ///< the value is NA
  std::size_t unknown = 0;           ///< not computed
};

/// A recorded change of a list, which can be reverted and reapplied.
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
