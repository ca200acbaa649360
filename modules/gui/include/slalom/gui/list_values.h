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

/// Values of one descriptor, one for each scenario of a list.
class ListColumn {
 public:
  explicit ListColumn(QuantityInfo info = {}) : info_(std::move(info)) {}
  void add(const std::optional<Value>& value);  ///< of the next scenario; none: not computed

  const QuantityInfo& info() const { return info_; }
  std::size_t size() const { return numbers_.size(); }
  bool has_number(std::size_t row) const;
  double number(std::size_t row) const { return numbers_[row]; }   ///< requires has_number()
  const std::vector<double>& numbers() const { return numbers_; }  ///< NaN where there is none
  std::size_t na_count() const { return na_; }
  std::size_t not_computed_count() const { return not_computed_; }

 private:
  QuantityInfo info_;
  std::vector<double> numbers_;
  std::size_t na_ = 0, not_computed_ = 0;
};

/// What a list knew of its scenarios at one time. Does not change, so that any thread may read it.
class ListValues {
 public:
  ListValues() = default;
  explicit ListValues(std::vector<std::string> hashes);
  void set(ListColumn column);  ///< as long as there are scenarios; throws std::logic_error

  std::size_t size() const { return hashes_.size(); }
  const std::string& hash(std::size_t row) const { return hashes_[row]; }
  std::optional<std::size_t> row_of(const std::string& hash) const;
  /// Of one scenario; nullopt where no number is known.
  std::optional<double> number(const std::string& id, const std::string& hash) const;
  const ListColumn* column(const std::string& id) const;  ///< null when it was not read

 private:
  std::vector<std::string> hashes_;
  std::unordered_map<std::string, std::size_t> rows_;
  std::map<std::string, ListColumn> columns_;
};

/// Reads the values that `list` keeps of these scenarios, of all descriptors in `ids`; computes
/// nothing. Reports one step for each scenario and descriptor. For a worker with a list of its own.
ListValues read_list_values(ScenarioList& list, const std::vector<std::string>& hashes,
                            const std::vector<std::string>& ids, const DescriptorView& view,
                            Progress& progress);

}  // namespace slalom
