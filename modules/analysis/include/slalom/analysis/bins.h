#pragma once

#include <slalom/results/run_columns.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// How the rows of a cross table are asked for.
struct BinSpec {
  enum class Kind {
    All,         ///< one bin with every run
    Edges,       ///< between given edges
    Quantiles,   ///< `count` bins with about as many scenarios each
    EqualWidth,  ///< `count` bins of equal width
    Index        ///< as the index `index` of a scenario list says; given edges once it was read
  };
  Kind kind = Kind::All;
  std::string descriptor;  ///< id; empty for All
  std::vector<double> edges;
  int count = 0;
  std::string index;  ///< name, of Kind::Index
};

/// Reads "all", "density:0,0.1,0.2,0.4" (edges, increasing), "density:10" (10 bins of equal width),
/// "density:q4" (4 bins with about as many scenarios each) or "density:@by_density" (an index of
/// the scenario list). Throws Error (Usage).
BinSpec parse_bin_spec(const std::string& text);

/// Several of them, separated by ';'.
std::vector<BinSpec> parse_bin_specs(const std::string& text);

/// Values v with low <= v < high; where `closed`, high too. No limits: every run.
struct Bin {
  std::optional<double> low, high;
  bool closed = false;

  bool contains(double value) const;
  std::string label() const;  ///< e.g. "[0, 0.1)", "all"
};

/// The bins of a specification, in increasing order; the last one is closed. Counted bins have
/// edges rounded to three digits of the range, outwards at both ends, so that labels are exact;
/// equal edges are merged, so there may be fewer bins than asked for, and none when there are no
/// values. Of a descriptor over all scenarios, or of any metric over all runs. Throws Error (Usage)
/// for an id that the table does not have, and for an index that was not read.
std::vector<Bin> make_bins(const BinSpec& spec, const RunColumns& table);
std::vector<Bin> make_bins(const BinSpec& spec, const ResultTable& table);

/// Values of a descriptor (of the run's scenario) or of a metric, one a run. The columns must
/// outlive it.
class RunValues {
 public:
  /// Throws Error (Usage) with the nearest name for an unknown id.
  RunValues(const RunColumns& table, const std::string& id);

  const QuantityInfo& info() const { return values_->info(); }
  bool is_na(std::size_t run) const { return values_->is_na(row(run)); }
  double operator()(std::size_t run) const { return values_->number(row(run)); }
  const std::string& reason(std::size_t run) const { return values_->reason(row(run)); }
  const ValueColumn& column() const { return *values_; }  ///< one value a scenario, or a run

 private:
  const ValueColumn* values_;
  const std::vector<std::uint32_t>* scenario_;  ///< null: one value a run

  std::size_t row(std::size_t run) const { return scenario_ ? (*scenario_)[run] : run; }
};

}  // namespace slalom
