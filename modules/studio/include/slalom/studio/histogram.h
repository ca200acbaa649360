#pragma once

#include <slalom/studio/list_values.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The distribution of a descriptor in a list. Bins are half-open, low <= v < high, as in
/// "density >= 0.1 and density < 0.2"; their edges are round numbers and cover all values.
struct Histogram {
  struct Bar {
    double low, high;
    std::size_t count;
    std::string label;  ///< "[0.1, 0.2)"
  };
  std::vector<Bar> bars;         ///< contiguous; empty if there is no number
  std::size_t na = 0;            ///< scenarios whose value is NA
  std::size_t not_computed = 0;  ///< scenarios without a computed value

  std::size_t max_count() const;
  std::optional<std::size_t> bar_of(double value) const;  ///< the bar that contains this value
};

/// With about `max_bars` bars. The edges are integers if all values are.
Histogram make_histogram(const ListColumn& column, int max_bars = 24);

}  // namespace slalom
