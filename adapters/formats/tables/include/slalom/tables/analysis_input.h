// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/bins.h>
#include <slalom/analysis/csv_columns.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Reads runs for an analysis: a result file or a folder of them, of which only the columns in
/// `ids` (see read_results()), or a table of numbers if the file is `csv` or its name does not end
/// with ".results": CSV, a workbook (.xlsx), JSON, or a benchmark database of OMPL. Throws Error
/// (File), for a known format of other programs with the way in.
ResultTable read_analysis_input(const std::string& path,
                                const std::optional<std::vector<std::string>>& ids, bool csv,
                                const CsvColumnOptions& options);

/// The runs of several such tables: see columns_from_csv(). Throws Error (File).
ResultTable read_analysis_tables(const std::vector<std::string>& paths,
                                 const CsvColumnOptions& options);

/// Replaces indexes by their edges in the scenario list. Throws Error (Usage) for an index without
/// a list, an unknown index and one of another descriptor.
std::vector<BinSpec> resolve_indexes(std::vector<BinSpec> specs, const std::string& list_path);

}  // namespace slalom
