// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/interpreter.h>

#include <string>
#include <vector>

namespace slalom {

/// A table for people: numbers to four digits, "x [low, high]" for a column with ".low" and
/// ".high", without the ids of runs.
struct ViewFields {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};
ViewFields view_fields(const DataTable& table);

/// The tables for display.
const std::vector<DataTable>& views_of(const Interpretation& interpretation);

}  // namespace slalom
