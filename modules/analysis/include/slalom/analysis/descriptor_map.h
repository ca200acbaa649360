#pragma once

#include <slalom/analysis/bins.h>
#include <slalom/analysis/cell.h>

#include <string>
#include <vector>

namespace slalom {

/// One field of a map: the runs of a method in the scenarios that lie in a bin of each descriptor.
struct MapField {
  std::vector<std::size_t> runs;  ///< places in the results
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
DescriptorMap build_descriptor_map(const RunColumns& table, const std::string& method,
                                   const BinSpec& rows, const BinSpec& columns,
                                   const std::string& metric, const AnalysisOptions& options);

/// The bin that a value lies in, or the number of bins where none.
std::size_t bin_of(const std::vector<Bin>& bins, double value);

}  // namespace slalom
