// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/bins.h>
#include <slalom/analysis/cell.h>

#include <string>
#include <vector>

namespace slalom {

/// A field of a map: the runs of a method in the scenarios of one bin of each descriptor.
struct MapField {
  std::vector<std::size_t> runs;  ///< indexes into the results
  Cell cell;
};

/// One metric of one method over the bins of two descriptors.
struct DescriptorMap {
  std::string method;
  Column column;
  QuantityInfo row_descriptor, column_descriptor;
  std::vector<Bin> rows, columns;
  std::vector<std::vector<MapField>> fields;  ///< [row][column]
  std::size_t left_out = 0;  ///< runs outside all bins, or without a value of a descriptor
  double confidence = 0.95;
};

/// Throws Error (Usage) for unknown ids.
DescriptorMap build_descriptor_map(const ResultTable& table, const std::string& method,
                                   const BinSpec& rows, const BinSpec& columns,
                                   const std::string& metric, const AnalysisOptions& options);

/// The index of the bin that contains a value, or the number of bins if there is none.
std::size_t bin_of(const std::vector<Bin>& bins, double value);

}  // namespace slalom
