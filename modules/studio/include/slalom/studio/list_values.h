#pragma once

#include <slalom/core/progress.h>
#include <slalom/core/value.h>
#include <slalom/io/scenario_list.h>

#include <cstddef>
#include <map>
#include <optional>
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

}  // namespace slalom
