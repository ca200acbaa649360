#pragma once

#include <slalom/results/run_record.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// How the rows of a cross table are asked for.
struct BinSpec {
  enum class Kind {
    All,        ///< one bin with every run
    Edges,      ///< between given edges
    Quantiles,  ///< `count` bins with about as many scenarios each
    EqualWidth  ///< `count` bins of equal width
  };
  Kind kind = Kind::All;
  std::string descriptor;  ///< id; empty for All
  std::vector<double> edges;
  int count = 0;
};

/// Reads "all", "density:0,0.1,0.2,0.4" (edges, increasing), "density:4" (4 bins with about as many
/// scenarios each) or "density:equal:4" (4 bins of equal width). Throws Error (Usage).
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

/// The bins of a specification for the scenarios of a table, in increasing order; the last one is
/// closed. Counted bins have edges rounded to three digits of the range, outwards at both ends, so
/// that labels are exact; equal edges are merged, so there may be fewer bins than asked for, and
/// none when no scenario has a value. Throws Error (Usage) for a descriptor that the table does not
/// have.
std::vector<Bin> make_bins(const BinSpec& spec, const ResultTable& table);

}  // namespace slalom
