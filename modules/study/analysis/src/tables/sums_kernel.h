// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace slalom {

/// The sums of a row of cells as parallel arrays, one value per cell: Kind::X begins at X * stride.
/// A sum with twice the digits of a double has a high and a low part, see PreciseSum.
struct SumArrays {
  enum Kind : std::size_t {
    ScenarioSum,        ///< of the values of the current scenario
    ScenarioSize,       ///< their number
    ScenarioPositives,  ///< those that are not 0
    SumHigh,            ///< of all values
    SumLow,
    SquaresHigh,
    SquaresLow,
    ScenarioSquaresHigh,  ///< of the sums of scenarios
    ScenarioSquaresLow,
    ScenarioProductsHigh,  ///< of their sums and sizes
    ScenarioProductsLow,
    PositiveProductsHigh,  ///< of their sums and numbers of positives
    PositiveProductsLow,
    SizeSquares,
    Available,
    Scenarios,
    Positives,          ///< values that are not 0
    PositiveScenarios,  ///< with such a value
    PositiveSquares,    ///< of the numbers of positives of scenarios
    PositiveSizes,      ///< of these numbers and the sizes of the scenarios
    KindCount
  };
  /// Strides are multiples of this.
  static constexpr std::size_t kLanes = 8;
};

/// Adds a value to each cell, in parallel (SIMD); none where it is NaN. The sums are bit-identical
/// with every instruction set.
void add_to_sums(const double* values, std::size_t stride, double* sums);

/// Ends the current scenario of each cell that has values of it.
void close_scenario_of_sums(std::size_t stride, double* sums);

}  // namespace slalom
