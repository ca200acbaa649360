#pragma once

#include <slalom/results/run_record.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Outcome of a run of which none is known, as in tables from elsewhere.
constexpr const char* kUnknownOutcome = "not recorded";

/// The values of one quantity, one a row: a number, or the reason why there is none. Takes 8 bytes
/// a row: a reason is kept as the payload of a NaN.
class ValueColumn {
 public:
  explicit ValueColumn(QuantityInfo info) : info_(std::move(info)) {}

  const QuantityInfo& info() const { return info_; }
  void reserve(std::size_t rows) { numbers_.reserve(rows); }
  void add(const Value& value);
  void add_number(double number);  ///< NA ("not a finite number") unless finite
  void add_na(const std::string& reason);

  std::size_t size() const { return numbers_.size(); }
  bool is_na(std::size_t row) const { return numbers_[row] != numbers_[row]; }
  double number(std::size_t row) const { return numbers_[row]; }  ///< NaN where NA
  const std::string& reason(std::size_t row) const;               ///< requires is_na(row)

  /// Row i becomes what row order[i] was.
  void reorder(const std::vector<std::size_t>& order);

  /// A share of runs with value 1 ("success"), not a mean.
  bool rate = false;
  /// Measured time: differs from run to run of a campaign.
  bool wall_clock = false;

 private:
  QuantityInfo info_;
  std::vector<double> numbers_;
  std::vector<std::string> reasons_;
  std::map<std::string, std::uint32_t> places_;  ///< of reasons
};

/// The runs of one or more result files as columns, for analyses of many of them: a million runs
/// with 40 metrics take 350 MB. Names are kept once; runs refer to them by place.
struct RunColumns {
  std::string source;  ///< file, for messages
  Manifest manifest;
  std::vector<std::string> scenario_hashes, scenario_names;  ///< parallel
  std::vector<std::string> methods;                          ///< sorted
  std::vector<std::string> outcomes;
  std::vector<std::uint32_t> scenario, method, outcome, repetition;  ///< one a run
  std::vector<ValueColumn> metrics;                                  ///< one value a run
  std::vector<ValueColumn> descriptors;                              ///< one value a scenario

  std::size_t size() const { return scenario.size(); }
};

/// The table as columns, runs in the same order. Wall-clock figures are metrics with `wall_clock`;
/// values of another version than `quantities` says are NA ("other version 1"). "success" is there
/// even where it was not recorded as a metric: then it follows from the outcome.
RunColumns to_columns(const ResultTable& table);

/// Adds "success" as the outcome tells it, where there is no such metric.
void add_success(RunColumns& columns);

/// Puts each name into `names` once; for the columns that refer to them by place.
class NameIndex {
 public:
  explicit NameIndex(std::vector<std::string>& names) : names_(names) {}
  std::uint32_t place_of(const std::string& name);

 private:
  std::vector<std::string>& names_;
  std::map<std::string, std::uint32_t> places_;
};

/// Sorts the methods by name, and what refers to them along.
void sort_methods(RunColumns& columns);

/// Run (scenario) i becomes what order[i] was; whatever refers to it goes along.
void reorder_runs(RunColumns& columns, const std::vector<std::size_t>& order);
void reorder_scenarios(RunColumns& columns, const std::vector<std::size_t>& order);

/// Null where there is none.
const ValueColumn* find_metric(const RunColumns& columns, const std::string& id);
const ValueColumn* find_descriptor(const RunColumns& columns, const std::string& id);

/// As of a RunRecord: "hash8/method/repetition".
std::string run_id(const RunColumns& columns, std::size_t run);

/// Whether an outcome is a failure of the method: neither a success nor one that says nothing of
/// the method, such as an unsolvable scenario, nor unknown.
bool is_failure(const std::string& outcome);

}  // namespace slalom
