#pragma once

#include <slalom/commands/describe_list.h>
#include <slalom/io/scenario_list.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Filter, order and grouping of a list.
struct ListViewRequest {
  std::string filter;             ///< an expression for parse_selection(); blank: all
  std::string sort;               ///< "name" or the id of a descriptor; empty: list order
  bool descending = false;        ///< scenarios without a value come last either way
  std::string group_by;           ///< name of an index; empty: no groups
  DescribeOptions describe = {};  ///< robot and sensor of the values to use
};

/// A group of a view: the scenarios in a range of an index, or in none.
struct ListGroup {
  std::string title;      ///< "density 0.1 to 0.2", "density NA"
  std::size_t first = 0;  ///< index of its first scenario in the view
  std::size_t count = 0;
};

/// The content of a view, as values: may be computed in any thread.
struct ListView {
  std::vector<std::string> hashes;     ///< in display order
  std::vector<std::uint32_t> by_hash;  ///< indices into `hashes`, by increasing hash
  std::vector<ListGroup> groups;       ///< in order, without gaps; empty without grouping
  std::size_t total = 0;               ///< scenarios in the list

  std::optional<std::size_t> index_of(const std::string& hash) const;
};

/// The selection for a `filter`, with the keys of the descriptors that it uses. Throws Error
/// (Usage) like parse_selection().
ListSelection filter_selection(const ScenarioList& list, const std::string& filter,
                               const DescribeOptions& describe);

/// Throws Error: Usage for an invalid filter, sort field or index, File when the list cannot be
/// read.
ListView make_list_view(const ScenarioList& list, const ListViewRequest& request);
/// The same for a file, for worker threads.
ListView make_list_view(const std::string& path, const ListViewRequest& request);

}  // namespace slalom
