#pragma once

#include <slalom/gui/list_values.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// How often values of a descriptor occur in a list. Bins hold low <= v < high, as in
/// "density >= 0.1 and density < 0.2"; their edges are round numbers, and no value lies outside.
struct Histogram {
  struct Bar {
    double low, high;
    std::size_t count;
    std::string label;  ///< "[0.1, 0.2)"
  };
  std::vector<Bar> bars;         ///< without gaps; empty when there is no number
  std::size_t na = 0;            ///< scenarios that have no value for a reason
  std::size_t not_computed = 0;  ///< scenarios whose value nobody asked for yet

  std::size_t largest_count() const;
  std::optional<std::size_t> bar_of(double value) const;  ///< which holds this value
};

/// Of about `most` bars. Whole numbers get bars of whole numbers.
Histogram make_histogram(const ListColumn& column, int most = 24);

}  // namespace slalom
