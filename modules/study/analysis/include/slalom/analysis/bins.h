// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Specification of the bins that form the rows of a cross table.
struct BinSpec {
  enum class Kind {
    All,         ///< one bin with every run
    Edges,       ///< given edges
    Quantiles,   ///< `count` bins with about equal numbers of scenarios
    EqualWidth,  ///< `count` bins of equal width
    Index        ///< the ranges of index `index` of a scenario list; resolved to Edges
  };
  Kind kind = Kind::All;
  std::string descriptor;  ///< id; empty for All
  std::vector<double> edges;
  int count = 0;
  std::string index;  ///< name, for Kind::Index
};

/// Reads "all", "density:0,0.1,0.2,0.4" (edges, increasing), "density:10" (10 bins of equal width),
/// "density:q4" (4 bins with about equal numbers of scenarios; "density" alone as well) or
/// "density:@by_density" (an index of the scenario list). Throws Error (Usage); `where` is the
/// option or key, for its message.
BinSpec parse_bin_spec(const std::string& text, const std::string& where = "rows");

/// Reads several specifications, separated by ';'.
std::vector<BinSpec> parse_bin_specs(const std::string& text, const std::string& where = "rows");

/// The interval low <= v < high, or low <= v <= high if `closed`. Without limits: all values.
struct Bin {
  std::optional<double> low, high;
  bool closed = false;

  bool contains(double value) const;
  std::string label() const;  ///< e.g. "[0, 0.1)", "144", "all"
};

/// The bins of a specification, in increasing order; the last one is closed. For Quantiles and
/// EqualWidth, edges are rounded to three digits of the range, outwards at both ends, so that
/// labels are exact; equal edges are merged, so there may be fewer bins than requested, and none if
/// there are no values. Bins are over all scenarios for a descriptor, and over all runs for a
/// metric. Throws Error (Usage) for an id that is not in the table, and for an unresolved index.
std::vector<Bin> make_bins(const BinSpec& spec, const ResultTable& table);

/// Values of a descriptor (of the run's scenario) or of a metric, one per run. Refers to the
/// columns, which must outlive it.
class RunValues {
 public:
  /// Throws Error (Usage) with the nearest name for an unknown id.
  RunValues(const ResultTable& table, const std::string& id);

  const QuantityInfo& info() const { return values_->info(); }
  bool is_na(std::size_t run) const { return values_->is_na(row(run)); }
  double operator()(std::size_t run) const { return values_->number(row(run)); }
  const std::string& reason(std::size_t run) const { return values_->reason(row(run)); }
  const ValueColumn& column() const { return *values_; }  ///< one value per scenario, or per run

 private:
  const ValueColumn* values_;
  const std::vector<std::uint32_t>* scenario_;  ///< null: one value per run

  std::size_t row(std::size_t run) const { return scenario_ ? (*scenario_)[run] : run; }
};

}  // namespace slalom
