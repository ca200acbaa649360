#pragma once

#include <slalom/analysis/interpreter.h>
#include <slalom/results/privileged.h>

#include <vector>

namespace slalom {

/// The methods that are privileged in any of the results.
PrivilegedMethods privileged_methods(const std::vector<ResultTable>& results);

/// Puts the mark behind the names of privileged methods and sets the footnotes. Names of tables,
/// which become names of files, and ids of runs stay as they are. Nothing changes without such
/// methods.
void mark_privileged(Interpretation& interpretation, const PrivilegedMethods& methods);
void mark_privileged(DataTable& table, const PrivilegedMethods& methods);
void mark_privileged(SummaryTable& summary, const PrivilegedMethods& methods);
void mark_privileged(CrossTable& table, const PrivilegedMethods& methods);

}  // namespace slalom
