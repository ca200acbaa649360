#include "interpreters.h"
#include "row_table.h"

#include <slalom/analysis/validity.h>
#include <slalom/core/error.h>

namespace slalom {
namespace {

DataTable validity_table(const ValidityTable& validity, const std::string& method) {
  RowTable rows("validity", "Rank correlation of descriptors with outcomes (Spearman)");
  for (const DescriptorValidity& entry : validity.validity) {
    if (!method.empty() && entry.method != method) continue;
    rows.begin_row();
    rows.add("method", Field{entry.method});
    rows.add("metric", Field{entry.metric});
    rows.add("descriptor", Field{entry.descriptor});
    rows.add("scenarios", entry.correlation.n);
    rows.add("rho", entry.correlation.rho, entry.correlation.interval);
  }
  return rows.table();
}

DataTable redundancy_table(const ValidityTable& validity) {
  RowTable rows("redundancy", "Rank correlation of descriptors with each other (Spearman)");
  for (const DescriptorRedundancy& entry : validity.redundancy) {
    rows.begin_row();
    rows.add("first", Field{entry.first});
    rows.add("second", Field{entry.second});
    rows.add("scenarios", entry.correlation.n);
    rows.add("rho", entry.correlation.rho, entry.correlation.interval);
  }
  return rows.table();
}

/// Square, for people; the lower half, for the matrix is symmetric.
DataTable redundancy_matrix(const ValidityTable& validity) {
  const std::size_t n = validity.descriptors.size();
  std::vector<std::vector<std::optional<double>>> rho(n, std::vector<std::optional<double>>(n));
  std::size_t next = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i; j < n; ++j) rho[j][i] = validity.redundancy[next++].correlation.rho;
  }
  RowTable rows("redundancy", "Rank correlation of descriptors with each other (Spearman)");
  for (std::size_t i = 0; i < n; ++i) {
    rows.begin_row();
    rows.add("descriptor", Field{validity.descriptors[i]});
    for (std::size_t j = 0; j < n; ++j) rows.add(validity.descriptors[j], rho[i][j]);
  }
  return rows.table();
}

class ValidityInterpreter : public Interpreter {
 public:
  std::string id() const override { return "validity"; }
  std::string help() const override {
    return "Say how descriptors go together with outcomes, and with each other";
  }
  std::vector<std::string> default_metrics() const override { return {"success", "spl"}; }
  bool needs_descriptors() const override { return true; }
  Interpretation interpret(const std::vector<RunColumns>& results,
                           const Question& question) const override {
    if (results[0].descriptors.empty()) {
      throw usage_error("validity", "the results have no descriptors", "descriptors of scenarios");
    }
    asked_methods(results[0], question.method);
    const ValidityTable validity =
        build_validity(results[0], question.metrics, question.comparison.analysis);
    const DataTable outcomes = validity_table(validity, question.method);
    return {
        {outcomes, redundancy_table(validity)}, {outcomes, redundancy_matrix(validity)}, {}, true};
  }
};

}  // namespace

std::unique_ptr<Interpreter> make_validity_interpreter() {
  return std::make_unique<ValidityInterpreter>();
}

}  // namespace slalom
