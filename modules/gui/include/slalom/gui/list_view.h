#pragma once

#include <slalom/commands/describe_list.h>
#include <slalom/io/scenario_list.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Which scenarios of a list are shown, and in what order.
struct ListViewRequest {
  std::string filter;       ///< an expression as of parse_selection(); blank: all
  std::string sort;         ///< "name" or the id of a descriptor; empty: the order of the list
  bool descending = false;  ///< what has no value comes last either way
  std::string group_by;     ///< name of an index; empty: no groups
  DescribeOptions describe = {};  ///< under which the values are kept that are spoken of
};

/// Scenarios that stand together in a view: those of one range of an index, or of none.
struct ListGroup {
  std::string title;      ///< "density 0.1 to 0.2", "density NA"
  std::size_t first = 0;  ///< place of its first scenario in the view
  std::size_t count = 0;
};

/// What is shown of a list, as values: may be computed in any thread.
struct ListView {
  std::vector<std::string> hashes;     ///< as shown, from top to bottom
  std::vector<std::uint32_t> by_hash;  ///< places in `hashes`, by increasing hash
  std::vector<ListGroup> groups;       ///< in order, without gaps; none without grouping
  std::size_t total = 0;               ///< scenarios in the list

  std::optional<std::size_t> place_of(const std::string& hash) const;
};

/// The selection that `filter` makes of a list, with the keys of the descriptors it speaks of.
/// Throws Error (Usage) where parse_selection() does.
ListSelection filter_selection(const ScenarioList& list, const std::string& filter,
                               const DescribeOptions& describe);

/// Throws Error: Usage for a filter, sorting or index that makes no sense here, File when the list
/// cannot be read.
ListView make_list_view(const ScenarioList& list, const ListViewRequest& request);
/// The same of a file, for workers.
ListView make_list_view(const std::string& path, const ListViewRequest& request);

}  // namespace slalom
