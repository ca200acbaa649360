// SPDX-License-Identifier: BSD-3-Clause
#include "shard_tables.h"
#include "warnings.h"

#include <slalom/analysis/table_sums.h>
#include <slalom/core/available_cores.h>
#include <slalom/io/result_files.h>
#include <slalom/io/result_parts.h>
#include <slalom/results/privileged.h>
#include <slalom/tables/analysis_input.h>

#include <filesystem>

namespace slalom {
namespace {

bool is_for_tables_of_shards(const InterpretArguments& arguments, const Interpreter& interpreter) {
  std::error_code ignored;
  return interpreter.id == "table" && !arguments.json && arguments.files.size() == 1 &&
         std::filesystem::is_directory(arguments.files[0], ignored);
}

/// Reads what the bins need; none if they are not of descriptors.
std::optional<std::vector<BinnedRows>> bin_all(const AnalysisQuery& query, ResultParts& parts) {
  std::vector<BinnedRows> rows;
  for (const BinSpec& spec : query.rows) {
    if (spec.kind != BinSpec::Kind::All) {
      if (find_descriptor(parts.outline(), spec.descriptor) == nullptr) return std::nullopt;
      parts.read_values(spec.descriptor);
    }
    rows.push_back(bin_rows(spec, parts.outline()));
  }
  rows.push_back(bin_rows({}, parts.outline()));  // of the summary
  return rows;
}

}  // namespace

std::optional<Interpretation> tables_of_shards(const InterpretArguments& arguments,
                                               const Interpreter& interpreter) {
  if (!is_for_tables_of_shards(arguments, interpreter)) return std::nullopt;
  ResultParts parts(arguments.files[0], worker_count(arguments.jobs));
  if (!parts.are_disjoint()) return std::nullopt;
  AnalysisQuery query = make_query(arguments.request, interpreter, parts.outline());
  query.rows = resolve_indexes(std::move(query.rows), arguments.scenarios);
  const auto rows = bin_all(query, parts);
  if (!rows) return std::nullopt;
  std::vector<std::string> ids = query.metrics;
  for (const BinSpec& spec : query.rows)
    if (spec.kind != BinSpec::Kind::All) ids.push_back(spec.descriptor);
  TableSums sums(*rows, query.metrics, query.method);
  std::size_t runs = 0;
  bool is_damaged = false;
  MethodFailures failures;
  const PrivilegedMethods privileged = privileged_methods(parts.outline().manifest);
  parts.for_each(ids, [&](ResultTable& part) {
    mark_privileged(part, privileged);
    sums.add(part);
    add_method_failures(part, part.source, failures);
    runs += part.size();
    is_damaged = is_damaged || !part.damaged.empty();
  });
  const AnalysisOptions& options = query.comparison.analysis;
  Interpretation found;
  std::vector<CrossTable> tables = sums.cross_tables(options);
  if (is_damaged || tables.empty()) return std::nullopt;
  tables.resize(tables.size() / rows->size() * query.rows.size());
  found.cross_tables = std::move(tables);
  if (!arguments.csv && query.method.empty())
    found.summary = sums.summary(query.rows.size(), options);
  found.remarks = query.method.empty() ? failures.lines() : failures.lines_of(query.method);
  found.footnote = privileged_footnote(privileged);
  warn_of_missing_runs(arguments.files[0], parts.files(), runs, planned_runs(parts.outline()));
  return found;
}

}  // namespace slalom
