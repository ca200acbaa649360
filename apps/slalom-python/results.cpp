// SPDX-License-Identifier: BSD-3-Clause
#include "results.h"

#include <slalom/analysis/analysis_request.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/evaluate.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_files.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace slalom {
namespace {

namespace py = pybind11;

py::list names_by_run(const std::vector<std::string>& names,
                      const std::vector<std::uint32_t>& indexes) {
  py::list list;
  for (const std::uint32_t index : indexes) list.append(names[index]);
  return list;
}

py::array_t<double> numbers_of(const ValueColumn& column, std::size_t runs,
                               const std::function<std::size_t(std::size_t)>& row_of) {
  py::array_t<double> values(static_cast<py::ssize_t>(runs));
  for (std::size_t run = 0; run < runs; ++run) values.mutable_at(run) = column.number(row_of(run));
  return values;
}

std::size_t same_row(std::size_t run) {
  return run;
}

/// Visits each repeatable metric, and each descriptor, with a function from a run to its row in the
/// column.
void for_each_column(
    const ResultTable& table,
    const std::function<void(const ValueColumn& column,
                             const std::function<std::size_t(std::size_t)>& row_of)>& visit) {
  for (const ValueColumn& column : table.metrics)
    if (!column.wall_clock) visit(column, same_row);
  for (const ValueColumn& column : table.descriptors)
    visit(column, [&](std::size_t run) { return table.scenario[run]; });
}

py::dict columns_of(const ResultTable& table) {
  py::dict columns;
  columns["scenario"] = names_by_run(table.scenario_names, table.scenario);
  columns["scenario_hash"] = names_by_run(table.scenario_hashes, table.scenario);
  columns["method"] = names_by_run(table.methods, table.method);
  columns["repetition"] =
      py::array(static_cast<py::ssize_t>(table.size()), table.repetition.data());
  columns["outcome"] = names_by_run(table.outcomes, table.outcome);
  py::list details;
  for (const RunDetails& run : table.details) details.append(run.outcome_detail);
  columns["detail"] = details;
  py::list reasons;
  for (std::size_t run = 0; run < table.size(); ++run) reasons.append(py::dict());
  for_each_column(table, [&](const ValueColumn& column, const auto& row_of) {
    for (std::size_t run = 0; run < table.size(); ++run)
      if (column.is_na(row_of(run)))
        reasons[run][py::str(column.info().id)] = column.reason(row_of(run));
  });
  columns["reasons"] = reasons;
  for_each_column(table, [&](const ValueColumn& column, const auto& row_of) {
    columns[py::str(column.info().id)] = numbers_of(column, table.size(), row_of);
  });
  return columns;
}

py::dict timing_of(const ResultTable& table) {
  py::dict columns;
  for (const ValueColumn& column : table.metrics)
    if (column.wall_clock)
      columns[py::str(column.info().id)] = numbers_of(column, table.size(), same_row);
  return columns;
}

py::dict reasons_of(const ResultTable& table) {
  py::dict reasons;
  for_each_column(table, [&](const ValueColumn& column, const auto& row_of) {
    py::dict by_row;
    for (std::size_t run = 0; run < table.size(); ++run)
      if (column.is_na(row_of(run))) by_row[py::int_(run)] = column.reason(row_of(run));
    reasons[py::str(column.info().id)] = by_row;
  });
  return reasons;
}

py::array_t<double> array_of(const Trajectory& trajectory) {
  py::array_t<double> array({static_cast<py::ssize_t>(trajectory.samples.size()),
                             static_cast<py::ssize_t>(Sample::kNumbers)});
  double* next = array.mutable_data();
  for (const Sample& sample : trajectory.samples)
    for (const double number : sample.numbers()) *next++ = number;
  return array;
}

/// The samples of each run in the order of the table.
py::list arrays_of(const ResultTable& table, const std::string& path) {
  ResultFiles files(path);
  py::list arrays;
  for (std::size_t run = 0; run < table.size(); ++run) {
    const std::string& hash = table.scenario_hashes[table.scenario[run]];
    for (const ResultFile* file : files.with_scenario(hash)) {
      const auto record = file->read_run(hash, table.methods[table.method[run]],
                                         static_cast<int>(table.repetition[run]));
      if (!record) continue;
      arrays.append(array_of(file->read_trajectory(*record)));
      break;
    }
  }
  return arrays;
}

}  // namespace

py::tuple results_of(const ResultTable& table, const std::string& path, bool trajectories) {
  const py::object arrays =
      trajectories ? py::object(arrays_of(table, path)) : py::object(py::none());
  return py::make_tuple(columns_of(table), timing_of(table), reasons_of(table), arrays,
                        py::cast(table), path);
}

namespace {

py::tuple read(const std::string& path, bool trajectories) {
  const ResultTable table = read_detailed_results(path);
  if (!table.damaged.empty())
    throw file_error(path, "damaged: " + join(table.damaged, ", "),
                     "slalom-analyze, which leaves out what is damaged");
  return results_of(table, path, trajectories);
}

/// Copies a result file, or merges those of a folder.
void save(const std::string& path, const std::string& output) {
  if (!ends_with(output, ".results"))
    throw usage_error(output, "is not the name of a result file", "FILE.results");
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) {
    require_regular_file(path, "a result file (.results)");
    std::ifstream file(path, std::ios::binary);
    return write_file_atomically(output, [&](std::ostream& out) { out << file.rdbuf(); });
  }
  const std::vector<std::string> files = campaign_files(path);
  MergedResults merged(output, files.at(0));
  for (const std::string& file : files) merged.add(file);
  merged.publish();
}

/// Returns what slalom-analyze summary prints.
std::string summarize(const ResultTable& table, const std::string& path) {
  const std::vector<Interpreter>& all = all_interpreters();
  const Interpreter& summary = *std::find_if(
      all.begin(), all.end(), [](const Interpreter& one) { return one.id == "summary"; });
  std::vector<ResultTable> results = {table};
  Interpretation found = interpret(summary, results, make_query({}, summary, table));
  MethodFailures failures;
  add_method_failures(table, path, failures);
  const auto lines = failures.lines();
  found.remarks.insert(found.remarks.begin(), lines.begin(), lines.end());
  return render_text(found);
}

}  // namespace

void bind_results(py::module_& module) {
  py::class_<ResultTable>(module, "ResultTable")
      .def_property_readonly("manifest", [](const ResultTable& table) { return table.manifest; });
  module.def("read_results", read);
  module.def("save_results", save);
  module.def("summary", summarize);
  module.def("cross_table", cross_table);
}

}  // namespace slalom
