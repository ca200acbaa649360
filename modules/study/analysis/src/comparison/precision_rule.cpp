// SPDX-License-Identifier: BSD-3-Clause
#include "../text/text_grid.h"
#include "rule_text.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/precision_rule.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

constexpr const char* kExpectedInterval =
    "\"interval(METRIC) < WIDTH\" or \"interval(METRIC) < WIDTH in "
    "BINS\", such as \"interval(success) < 0.1 in density:10\"";

bool is_narrow_enough(const Cell& cell, double width) {
  const auto& interval = stated_interval(cell);
  return interval && interval->high - interval->low < width;
}

}  // namespace

PrecisionRule parse_precision_rule(const std::string& text) {
  const auto found = match_rule(
      text,
      "[[:space:]]*interval\\([[:space:]]*([[:alnum:]_]+)[[:space:]]*\\)[[:space:]]*<"
      "[[:space:]]*([^[:space:]]+)([[:space:]]+in[[:space:]]+(.*[^[:space:]]))?[[:space:]]*");
  PrecisionRule rule;
  if (!found || !parse_number(*(*found)[2], rule.width) || !(rule.width > 0))
    throw usage_error("--until", "invalid stopping rule '" + text + "'", kExpectedInterval);
  rule.metric = *(*found)[1];
  if (const auto& bins = (*found)[4]) rule.rows = parse_bin_spec(*bins, "--until");
  return rule;
}

double look_confidence(double confidence) {
  return 1 - 0.6 * test_level(confidence);
}

std::vector<PrecisionCell> precision_cells(const ResultTable& runs, const PrecisionRule& rule,
                                           const AnalysisOptions& options) {
  AnalysisOptions at_look = options;
  at_look.confidence = look_confidence(options.confidence);
  std::vector<PrecisionCell> cells;
  for (const CrossTable& table : build_cross_tables(runs, {rule.rows}, {rule.metric}, at_look)) {
    for (const CrossRow& row : table.rows) {
      const Cell& cell = row.cells.front();
      cells.push_back({table.method, row.bin, cell, is_narrow_enough(cell, rule.width)});
    }
  }
  return cells;
}

BinSpec with_edges(const std::string& descriptor, const std::vector<Bin>& bins) {
  if (bins.empty() || !bins.front().low) return {};
  BinSpec spec;
  spec.kind = BinSpec::Kind::Edges;
  spec.descriptor = descriptor;
  spec.edges.push_back(*bins.front().low);
  for (const Bin& bin : bins) spec.edges.push_back(*bin.high);
  return spec;
}

std::string render_precision_text(const PrecisionRule& rule,
                                  const std::vector<PrecisionCell>& cells) {
  TextGrid grid({"method", rule.rows.descriptor.empty() ? "scenarios" : rule.rows.descriptor,
                 "runs", rule.metric, "interval", "width", "reached"});
  for (const PrecisionCell& entry : cells) {
    const Cell& cell = entry.cell;
    const auto& interval = stated_interval(cell);
    const std::string width = interval ? format_fixed(interval->high - interval->low, 4) : "-";
    grid.add_row({{printable_line(entry.method)},
                  {entry.bin.label()},
                  {std::to_string(cell.n)},
                  {estimate_text(cell, 3)},
                  {interval_text(cell, 3)},
                  {width},
                  {entry.reached ? "yes" : "no"}});
  }
  return grid.text();
}

}  // namespace slalom
