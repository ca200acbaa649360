// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/commands/describe_list.h>
#include <slalom/core/progress.h>
#include <slalom/core/value.h>
#include <slalom/io/result_fields.h>
#include <slalom/io/scenario_list.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace slalom {

/// Values of one descriptor for all scenarios of a list.
class ListColumn {
 public:
  explicit ListColumn(QuantityInfo info = {}) : info_(std::move(info)) {}
  void add(const std::optional<Value>& value);  ///< of the next scenario; nullopt: not computed

  const QuantityInfo& info() const { return info_; }
  std::size_t size() const { return numbers_.size(); }
  bool has_number(std::size_t row) const;
  double number(std::size_t row) const { return numbers_[row]; }   ///< requires has_number()
  const std::vector<double>& numbers() const { return numbers_; }  ///< NaN for no number
  std::size_t na_count() const { return na_; }
  std::size_t not_computed_count() const { return not_computed_; }

 private:
  QuantityInfo info_;
  std::vector<double> numbers_;
  std::size_t na_ = 0, not_computed_ = 0;
};

/// A snapshot of descriptor values of a list; immutable once filled, so that any thread may read
/// it.
class ListValues {
 public:
  ListValues() = default;
  explicit ListValues(std::vector<std::string> hashes);
  void set(ListColumn column);  ///< throws std::logic_error if its size differs from size()

  std::size_t size() const { return hashes_.size(); }
  const std::string& hash(std::size_t row) const { return hashes_[row]; }
  /// The value of a scenario; nullopt if there is no number.
  std::optional<double> number(const std::string& id, const std::string& hash) const;
  const ListColumn* column(const std::string& id) const;  ///< null if it was not read

 private:
  std::vector<std::string> hashes_;
  std::unordered_map<std::string, std::size_t> rows_;
  std::map<std::string, ListColumn> columns_;
};

/// Reads the stored values of these scenarios for all descriptors in `ids`, without computing any.
/// Reports one step per scenario and descriptor. For worker threads with their own `list`.
ListValues read_list_values(ScenarioList& list, const std::vector<std::string>& hashes,
                            const std::vector<std::string>& ids, const DescriptorView& view,
                            Progress& progress);

/// Filter, order and grouping of a list.
struct ListViewRequest {
  std::string filter;             ///< an expression for parse_selection(); blank: all
  std::string sort;               ///< "name", a descriptor or a result; empty: list order
  bool descending = false;        ///< scenarios without a value come last either way
  std::string group_by;           ///< name of an index; empty: no groups
  DescribeOptions describe = {};  ///< robot and sensor of the values to use
  /// Whose fields filter and sort may use; null for none.
  std::shared_ptr<const ResultFields> results = nullptr;
  /// A scenario that keeps this index while a value that filter or order need is not computed.
  struct Held {
    std::string hash;
    std::size_t index;
  };
  std::optional<Held> held = std::nullopt;
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

/// Whether the view is sorted by a descriptor.
bool is_descriptor_sort(const ListViewRequest& request);

/// The selection for a filter, with the keys of the descriptors that it uses but without results.
/// Throws Error (Usage) like parse_selection().
ListSelection filter_selection(const ScenarioList& list, const ListViewRequest& request);

/// Throws Error: Usage for an invalid filter, sort field or index, File when the list cannot be
/// read.
ListView make_list_view(const ScenarioList& list, const ListViewRequest& request);
/// The same for a file, for worker threads.
ListView make_list_view(const std::string& path, const ListViewRequest& request);

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

  /// Heights (pixels) of lines, and the number of scenarios side by side: 1 in a list, more in a
  /// grid. A header has a row of its own.
  struct Layout {
    double scenario, group;
    std::size_t across = 1;
  };
  /// A cell of a row that is divided into `columns` of equal width.
  struct Place {
    double top, height;  ///< pixels
    std::size_t column, columns;
  };
  double height(const Layout& layout) const;                     ///< of all rows, pixels
  Place place_of(std::size_t line, const Layout& layout) const;  ///< requires line < size()
  /// The first line of the row at offset `y` (pixels), clamped to the rows; requires size() > 0.
  std::size_t line_at(double y, const Layout& layout) const;
  /// The line that is this number of rows below, above if negative, and in the same column where
  /// the row has it; clamped to the rows. Requires line < size().
  std::size_t line_below(std::size_t line, int rows, std::size_t across) const;

 private:
  struct Block {
    std::size_t first, end;  ///< lines
  };
  struct Group {
    std::size_t header;        ///< line of the header
    std::size_t first, count;  ///< range of its scenarios in the view
    bool closed;
    std::size_t shown() const { return closed ? 0 : count; }
  };
  std::size_t group_at(std::size_t line) const;  ///< requires groups
  double height_of_groups(std::size_t count, const Layout& layout) const;
  /// The lines around a line that are divided into rows: a header, or the scenarios below one.
  Block block_of(std::size_t line) const;

  std::vector<Group> groups_;
  std::size_t size_ = 0;
};

}  // namespace slalom
