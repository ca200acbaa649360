// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/table_sums.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/statistics/paired_rates.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

namespace slalom {
namespace {

std::vector<std::uint32_t> rows_of(const BinnedRows& rows, const ValueColumn& values) {
  std::vector<std::uint32_t> found(values.size(), RunRows::kUndescribed);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (values.is_na(i)) continue;
    const double value = values.number(i);
    const auto bin = std::find_if(rows.bins.begin(), rows.bins.end(),
                                  [value](const Bin& one) { return one.contains(value); });
    found[i] = bin == rows.bins.end() ? RunRows::kOutside
                                      : static_cast<std::uint32_t>(bin - rows.bins.begin());
  }
  return found;
}

/// The runs by scenario; empty if they are in that order.
std::vector<std::uint32_t> order_by_scenario(const ResultTable& part) {
  if (std::is_sorted(part.scenario.begin(), part.scenario.end())) return {};
  std::vector<std::uint32_t> order(part.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return part.scenario[a] < part.scenario[b];
  });
  return order;
}

void add_notes(CrossTable& cross) {
  if (cross.outside > 0) {
    cross.notes.push_back(count_text(cross.outside, "run") + " left out: " + cross.descriptor.id +
                          " outside the bins");
  }
  if (cross.undescribed > 0) {
    cross.notes.push_back(count_text(cross.undescribed, "run") +
                          " left out: scenario has no value of " + cross.descriptor.id);
  }
}

std::vector<std::optional<Trend>> trends_of(const std::vector<const RowSums*>& rows,
                                            const std::vector<Column>& columns) {
  std::vector<std::optional<Trend>> trends(columns.size());
  for (std::size_t column = 0; rows.size() > 1 && column < columns.size(); ++column) {
    if (columns[column].wall_clock) continue;
    std::vector<CellSums> bins;
    for (const RowSums* row : rows) bins.push_back(row->cell(column));
    trends[column] = find_trend(bins, columns[column].info.is_rate());
  }
  return trends;
}

/// All trends of the tables are one family.
void correct_trends(std::vector<CrossTable>& tables) {
  std::vector<Trend*> family;
  std::vector<double> p;
  for (CrossTable& table : tables) {
    for (std::optional<Trend>& trend : table.trends) {
      if (!trend || trend->test.kind == TrendTest::Kind::NoVariation) continue;
      family.push_back(&*trend);
      p.push_back(trend->test.p);
    }
  }
  const std::vector<double> adjusted = holm_adjusted(p);
  for (std::size_t i = 0; i < family.size(); ++i) family[i]->adjusted_p = adjusted[i];
}

}  // namespace

BinnedRows bin_rows(const BinSpec& spec, const ResultTable& table) {
  if (spec.kind == BinSpec::Kind::All)
    return {{"all", 1, "All scenarios", "-", Direction::None}, {Bin{}}};
  return {RunValues(table, spec.descriptor).info(), make_bins(spec, table)};
}

RunRows::RunRows(const BinnedRows& rows, const ResultTable& table) : scenario_(&table.scenario) {
  if (rows.bins.size() == 1 && !rows.bins[0].low) return;  // all runs
  const ValueColumn& values = RunValues(table, rows.descriptor.id).column();
  if (find_descriptor(table, rows.descriptor.id) != &values) scenario_ = nullptr;
  rows_ = rows_of(rows, values);
}

TableSums::TableSums(std::vector<BinnedRows> rows, std::vector<std::string> metrics,
                     std::string method)
    : rows_(std::move(rows)),
      metrics_(std::move(metrics)),
      method_(std::move(method)),
      columns_(metrics_.size()) {}

void TableSums::add(const ResultTable& part) {
  known_metrics_.clear();
  for (const ValueColumn& column : part.metrics) known_metrics_.push_back(column.info().id);
  for (std::size_t i = 0; i < metrics_.size(); ++i) {
    const ValueColumn* column = find_metric(part, metrics_[i]);
    if (column != nullptr) columns_[i] = Column{column->info(), column->wall_clock};
  }
  const std::vector<Method*> methods = methods_of(part);
  count_outcomes(part, methods);
  const std::vector<std::uint32_t> order = order_by_scenario(part);
  for (std::size_t table = 0; table < rows_.size(); ++table) add_table(table, part, methods, order);
  end_part(part, methods);
  ++parts_;
}

/// Null for those that are left out.
std::vector<TableSums::Method*> TableSums::methods_of(const ResultTable& part) {
  std::vector<Method*> methods;
  for (const std::string& name : part.methods) {
    if (!method_.empty() && name != method_) {
      methods.push_back(nullptr);
      continue;
    }
    Method& method = methods_[name];
    if (method.tables.empty()) {
      method.tables.resize(rows_.size());
      for (std::size_t table = 0; table < rows_.size(); ++table)
        method.tables[table].rows.assign(rows_[table].bins.size(),
                                         {0, 0, RowSums(metrics_.size())});
    }
    methods.push_back(&method);
  }
  return methods;
}

void TableSums::count_outcomes(const ResultTable& part, const std::vector<Method*>& methods) {
  const std::size_t outcomes = part.outcomes.size();
  std::vector<std::size_t> counts(part.methods.size() * outcomes, 0);
  for (std::size_t run = 0; run < part.size(); ++run)
    ++counts[part.method[run] * outcomes + part.outcome[run]];
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0 && methods[i / outcomes] != nullptr)
      methods[i / outcomes]->outcomes[part.outcomes[i % outcomes]] += counts[i];
}

void TableSums::add_table(std::size_t table, const ResultTable& part,
                          const std::vector<Method*>& methods,
                          const std::vector<std::uint32_t>& order) {
  const RunRows row_of(rows_[table], part);
  const std::size_t rows = rows_[table].bins.size();
  std::vector<bool> failure;
  for (const std::string& outcome : part.outcomes) failure.push_back(is_failure(outcome));
  std::vector<RunInRow> used;
  used.reserve(part.size());
  for (std::size_t i = 0; i < part.size(); ++i) {
    const std::size_t run = order.empty() ? i : order[i];
    if (methods[part.method[run]] == nullptr) continue;
    Rows& sums = methods[part.method[run]]->tables[table];
    const std::uint32_t row = row_of(run);
    if (row == RunRows::kOutside) ++sums.outside;
    if (row == RunRows::kUndescribed) ++sums.undescribed;
    if (row >= rows) continue;
    ++sums.rows[row].runs;
    sums.rows[row].failures += failure[part.outcome[run]] ? 1 : 0;
    used.push_back({static_cast<std::uint32_t>(run),
                    static_cast<std::uint32_t>(part.method[run] * rows + row)});
  }
  add_values(table, part, methods, used);
}

/// Block by block: values are read by metric and added by run.
void TableSums::add_values(std::size_t table, const ResultTable& part,
                           const std::vector<Method*>& methods, const std::vector<RunInRow>& runs) {
  constexpr std::size_t kBlock = 64;
  static const std::string kMissing = kNotRecorded;
  const std::size_t stride = RowSums::padded(metrics_.size()), rows = rows_[table].bins.size();
  std::vector<RowSums*> sums(methods.size() * rows, nullptr);
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (methods[i / rows] != nullptr)
      sums[i] = &methods[i / rows]->tables[table].rows[i % rows].cells;
  std::vector<const ValueColumn*> columns;
  for (const std::string& id : metrics_) columns.push_back(find_metric(part, id));
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> block(kBlock * stride, kNone);
  for (std::size_t begin = 0; begin < runs.size(); begin += kBlock) {
    const std::size_t size = std::min(kBlock, runs.size() - begin);
    for (std::size_t metric = 0; metric < columns.size(); ++metric) {
      const ValueColumn* values = columns[metric];
      for (std::size_t i = 0; i < size; ++i) {
        const auto [run, row] = runs[begin + i];
        const bool is_na = values == nullptr || values->is_na(run);
        block[i * stride + metric] = is_na ? kNone : values->number(run);
        if (is_na) sums[row]->add_na(metric, values == nullptr ? kMissing : values->reason(run));
      }
    }
    for (std::size_t i = 0; i < size; ++i)
      sums[runs[begin + i].row]->add(&block[i * stride], part.scenario[runs[begin + i].run]);
  }
}

void TableSums::end_part(const ResultTable& part, const std::vector<Method*>& methods) {
  const auto key_of = [&](std::uint32_t scenario) {
    // Names and hashes do not contain the separator: the texts are in the order of the pairs.
    const std::string text = part.scenario_names[scenario] + '\0' + part.scenario_hashes[scenario];
    const auto [found, is_new] =
        scenario_keys_.try_emplace(text, static_cast<std::uint32_t>(scenarios_.size()));
    if (is_new) scenarios_.push_back(text);
    return found->second;
  };
  for (Method* method : methods) {
    if (method == nullptr) continue;
    for (Rows& rows : method->tables)
      for (Row& row : rows.rows) row.cells.end_part(key_of);
  }
}

std::vector<Column> TableSums::columns() const {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < metrics_.size(); ++i) {
    if (!columns_[i]) throw unknown_metric(metrics_[i], known_metrics_);
    columns.push_back(*columns_[i]);
  }
  return columns;
}

std::vector<Cell> TableSums::cells_of(const Row& row, const AnalysisOptions& options) const {
  std::vector<std::size_t> ranks(scenarios_.size());
  std::function<std::size_t(std::uint32_t)> rank_of;
  if (parts_ > 1) {  // a single part has its own order
    std::size_t rank = 0;
    for (const auto& [text, key] : scenario_keys_) ranks[key] = rank++;
    rank_of = [&](std::uint32_t key) { return ranks[key]; };
  }
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < metrics_.size(); ++i)
    cells.push_back(
        make_cell(row.cells.cell(i), row.runs, row.failures, *columns_[i], options, rank_of));
  return cells;
}

std::vector<CrossTable> TableSums::cross_tables(const AnalysisOptions& options) const {
  require_valid(options);
  const std::vector<Column> columns = this->columns();
  std::vector<CrossTable> tables;
  for (std::size_t table = 0; table < rows_.size(); ++table) {
    for (const auto& [name, method] : methods_) {
      CrossTable& cross = tables.emplace_back();
      cross.method = name;
      cross.columns = columns;
      cross.confidence = options.confidence;
      cross.descriptor = rows_[table].descriptor;
      cross.title = name + " by " + cross.descriptor.id;
      cross.outside = method.tables[table].outside;
      cross.undescribed = method.tables[table].undescribed;
      for (std::size_t i = 0; i < rows_[table].bins.size(); ++i) {
        const Row& row = method.tables[table].rows[i];
        cross.rows.push_back({rows_[table].bins[i], row.runs, {}, {}, cells_of(row, options)});
      }
      std::vector<const RowSums*> sums;
      for (const Row& row : method.tables[table].rows) sums.push_back(&row.cells);
      cross.trends = trends_of(sums, columns);
      add_notes(cross);
    }
  }
  correct_trends(tables);
  return tables;
}

SummaryTable TableSums::summary(std::size_t rows, const AnalysisOptions& options) const {
  require_valid(options);
  SummaryTable summary;
  summary.columns = columns();
  summary.confidence = options.confidence;
  std::set<std::string> outcomes;
  for (const auto& [name, method] : methods_) {
    const Row& row = method.tables.at(rows).rows.at(0);
    summary.methods.push_back({name, row.runs, method.outcomes, cells_of(row, options)});
    for (const auto& [outcome, count] : method.outcomes) outcomes.insert(outcome);
  }
  for (const bool success : {true, false})
    for (const std::string& outcome : outcomes)
      if ((outcome == "success") == success) summary.outcomes.push_back(outcome);
  return summary;
}

}  // namespace slalom
