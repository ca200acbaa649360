// SPDX-License-Identifier: BSD-3-Clause
#include "results.h"

#include <functional>
#include <pybind11/numpy.h>

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

}  // namespace

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
    if (!by_row.empty()) reasons[py::str(column.info().id)] = by_row;
  });
  return reasons;
}

py::list arrays_of(const ResultTable& table,
                   const std::map<std::string, Trajectory>& trajectories) {
  py::list arrays;
  for (std::size_t run = 0; run < table.size(); ++run) {
    const auto& samples = trajectories.at(run_id(table, run)).samples;
    py::array_t<double> array(
        {static_cast<py::ssize_t>(samples.size()), static_cast<py::ssize_t>(Sample::kNumbers)});
    double* next = array.mutable_data();
    for (const Sample& sample : samples)
      for (const double number : sample.numbers()) *next++ = number;
    arrays.append(array);
  }
  return arrays;
}

}  // namespace slalom
