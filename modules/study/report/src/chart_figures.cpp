// SPDX-License-Identifier: BSD-3-Clause
#include "svg_elements.h"

#include <slalom/core/text.h>
#include <slalom/report/figures.h>
#include <slalom/statistics/quantile.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slalom {
namespace {

using svg::document;
using svg::kLine;
using svg::kMargin;
using svg::Plot;
using svg::segment;
using svg::text;
using svg::width_of_text;

/// The values between the ends of an axis.
struct Axis {
  static constexpr int kMaxTicks = 6;

  double low = 0, high = 1;

  double part(double value) const { return (value - low) / (high - low); }

  /// About five round numbers: 1, 2 or 5 times a power of ten apart.
  std::vector<double> ticks() const {
    const double raw = (high - low) / 5;
    if (!(raw > 0) || !std::isfinite(raw)) return {};
    double power = 1;
    while (power > raw) power /= 10;
    while (10 * power <= raw) power *= 10;
    double step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
      if (raw <= factor * power) step = factor * power;
    std::vector<double> found;
    const double first = std::ceil(low / step - 1e-9);
    for (int i = 0; i <= kMaxTicks && (first + i) * step <= high + 1e-9 * step; ++i)
      found.push_back((first + i) * step + 0.0);  // no negative zero
    return found;
  }
};

/// The axis of values: that of the range of a rate, else from the least to the largest.
Axis axis_of(const QuantityInfo& info, const std::vector<double>& values) {
  if (info.kind == QuantityKind::Rate || values.empty()) return {};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (*low == *high) {
    const double half = std::max(0.5, std::abs(*low) / 2);  // large numbers have no fractions
    return {*low - half, *high + half};
  }
  const double margin = 0.03 * (*high - *low);
  return {*low == 0 ? 0 : *low - margin, *high + margin};
}

std::string label_of(const QuantityInfo& info) {
  return info.name + (info.unit == "-" || info.unit.empty() ? "" : " [" + info.unit + "]");
}

std::string x_ticks(const Plot& plot, const Axis& axis) {
  std::string content;
  for (const double value : axis.ticks())
    content += plot.x_tick(axis.part(value), fmt::format("{:.3g}", value));
  return content;
}

std::string y_ticks(const Plot& plot, const Axis& axis) {
  std::string content;
  for (const double value : axis.ticks())
    content += plot.y_tick(axis.part(value), fmt::format("{:.3g}", value));
  return content;
}

std::string legend(const Plot& plot, std::size_t index, const std::string& name,
                   const std::string& color) {
  const auto [left, top] = plot.legend(index);
  return segment(left, top, left + 20, top, 3, color) + text(left + 26, top + 4, "start", name);
}

std::string point(double x, double y, double radius, const std::string& color, double opacity = 1) {
  return fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" fill-opacity=\"{:.2f}\"/>", x,
      y, radius, color, opacity);
}

/// A mean over the runs with a value, hollow where it is that of the survivors only: a disc,
/// square, triangle or diamond, by the method.
std::string mean_point(double x, double y, const Cell& cell, std::size_t index) {
  constexpr std::array kMarks = {"M3.2 0A3.2 3.2 0 1 1 -3.2 0A3.2 3.2 0 1 1 3.2 0Z",
                                 "M-2.9 -2.9H2.9V2.9H-2.9Z", "M0 -3.6L3.6 2.8H-3.6Z",
                                 "M0 -4L4 0L0 4L-4 0Z"};
  const std::string color = method_color(index);
  return fmt::format(
      "<path transform=\"translate({:.1f} {:.1f})\" d=\"{}\" fill=\"{}\" stroke=\"{}\" "
      "stroke-width=\"1.4\"><title>n = {} of {}</title></path>",
      x, y, kMarks[index % kMarks.size()],
      is_survivors_only(cell.n, cell.available) ? "#ffffff" : color, color, cell.available, cell.n);
}

/// Numbers of values in a category: one of all methods, else one of each if there is room, or their
/// range.
std::string counts_text(const std::vector<std::size_t>& counts, double room) {
  if (counts.empty()) return "";
  const auto [low, high] = std::minmax_element(counts.begin(), counts.end());
  if (*low == *high) return fmt::format("n = {}", *low);
  const std::string each = fmt::format("n = {}", fmt::join(counts, ", "));
  return width_of_text(each) <= room ? each : fmt::format("n = {} to {}", *low, *high);
}

/// The colors of outcomes in reports.
std::string outcome_color(const std::string& outcome) {
  if (outcome == "success") return "#11703f";
  if (outcome == "collision") return "#b8231a";
  if (outcome == "left_workspace") return "#a3195b";
  if (outcome == "timeout") return "#855300";
  if (outcome == "stuck") return "#34518f";
  return outcome.rfind("method_", 0) == 0 ? "#7a3fb0" : "#5b6472";
}

/// The values of a method's runs, ascending, and how many runs it has.
struct MethodValues {
  std::vector<double> values;
  std::size_t runs = 0;
};

std::vector<MethodValues> values_by_method(const ResultTable& runs, const RunValues& values) {
  std::vector<MethodValues> by_method(runs.methods.size());
  for (std::size_t run = 0; run < runs.size(); ++run) {
    MethodValues& method = by_method[runs.method[run]];
    ++method.runs;
    if (!values.is_na(run)) method.values.push_back(values(run));
  }
  for (MethodValues& method : by_method) std::sort(method.values.begin(), method.values.end());
  return by_method;
}

std::vector<double> all_of(const std::vector<MethodValues>& methods) {
  std::vector<double> all;
  for (const MethodValues& method : methods)
    all.insert(all.end(), method.values.begin(), method.values.end());
  return all;
}

/// A line through cells, at the places of its categories; null where there is none.
struct CellLine {
  std::string name;
  std::vector<const Cell*> cells;
};

/// Estimates with their intervals over categories, a line per method.
std::string lines_figure(const QuantityInfo& info, const std::string& x_label,
                         const std::vector<std::string>& categories,
                         const std::vector<CellLine>& lines, const FigureStyle& style) {
  const Plot plot(style);
  std::vector<double> ends;
  for (const CellLine& line : lines)
    for (const Cell* cell : line.cells) {
      if (cell == nullptr) continue;
      ends.push_back(*cell->estimate);
      if (cell->interval) ends.insert(ends.end(), {cell->interval->low, cell->interval->high});
    }
  const Axis axis = axis_of(info, ends);
  const double room = plot.width() / static_cast<double>(categories.size());
  const auto x_of = [&](std::size_t category) {
    return plot.x(0) + room * (static_cast<double>(category) + 0.5);
  };
  const bool broken = std::any_of(categories.begin(), categories.end(),
                                  [&](const auto& label) { return width_of_text(label) > room; });
  std::string content = plot.frame(x_label, label_of(info), broken ? 3 : 2) + y_ticks(plot, axis);
  bool any_hollow = false;
  for (std::size_t i = 0; i < categories.size(); ++i) {
    std::vector<std::size_t> counts;
    for (const CellLine& line : lines)
      if (line.cells[i] != nullptr) counts.push_back(line.cells[i]->available);
    const std::size_t end = broken ? std::min(categories[i].find(' '), categories[i].size()) : 0;
    double y = plot.y(0) + 18;
    for (const std::string& part :
         {categories[i].substr(0, end), categories[i].substr(end), counts_text(counts, room - 6)}) {
      if (part.empty()) continue;
      content += text(x_of(i), y, "middle", trim(part));
      y += 14;
    }
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // Beside each other, so that intervals do not hide each other.
    const double shift = std::min(5.0, room / static_cast<double>(lines.size() + 1)) *
                         (static_cast<double>(i) - static_cast<double>(lines.size() - 1) / 2);
    const std::string color = method_color(i);
    std::string points, marks;
    for (std::size_t at = 0; at < lines[i].cells.size(); ++at) {
      const Cell* const cell = lines[i].cells[at];
      if (cell == nullptr) continue;
      const double x = x_of(at) + shift, y = plot.y(axis.part(*cell->estimate));
      points += fmt::format("{:.1f},{:.1f} ", x, y);
      if (cell->interval)
        marks += segment(x, plot.y(axis.part(cell->interval->low)), x,
                         plot.y(axis.part(cell->interval->high)), 1.2, color);
      marks += mean_point(x, y, *cell, i);
      any_hollow = any_hollow || is_survivors_only(cell->n, cell->available);
    }
    content += svg::method_line(points, i) + marks + svg::method_key(plot, i, lines[i].name);
  }
  if (any_hollow) {
    const auto [left, top] = plot.legend(lines.size());
    content += text(left, top + 8, "start", "hollow: > 10 % of runs NA");
  }
  return plot.document(content, lines.size() + 1);
}

/// The cell, if it has an estimate.
const Cell* drawn(const Cell& cell) {
  return cell.estimate ? &cell : nullptr;
}

}  // namespace

std::string bins_figure(const std::vector<CrossTable>& tables, const Column& column,
                        const FigureStyle& style) {
  std::vector<std::string> bins;
  std::vector<CellLine> lines;
  for (const CrossTable& table : tables) {
    lines.push_back({table.method, std::vector<const Cell*>(table.rows.size(), nullptr)});
    for (std::size_t row = 0; row < table.rows.size(); ++row)
      for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i].info.id == column.info.id)
          lines.back().cells[row] = drawn(table.rows[row].cells[i]);
  }
  if (tables.empty()) return lines_figure(column.info, "", {}, {}, style);
  for (const CrossRow& row : tables.front().rows) bins.push_back(row.bin.label());
  return lines_figure(column.info, label_of(tables.front().descriptor), bins, lines, style);
}

std::string history_figure(const History& history, const std::string& metric,
                           const std::vector<std::string>& results) {
  QuantityInfo info;
  std::vector<CellLine> lines;
  for (const HistoryCurve& curve : history.curves) {
    if (curve.column.info.id != metric) continue;
    info = curve.column.info;
    lines.push_back({curve.method, std::vector<const Cell*>(results.size(), nullptr)});
    for (const HistoryPoint& point : curve.points)
      lines.back().cells[point.result] = drawn(point.cell);
  }
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < results.size(); ++i) numbers.push_back(std::to_string(i + 1));
  return lines_figure(info, join(results, ", "), numbers, lines, {});
}

std::string map_figure(const std::vector<DescriptorMap>& maps, const FigureStyle& style) {
  constexpr double kCellHeight = 40, kNames = 130, kRight = 20, kPanel = 90, kLeastCell = 50;
  std::size_t columns = 1;
  for (const DescriptorMap& map : maps) columns = std::max(columns, map.columns.size());
  const double cell_width = style.width
                                ? std::max(kLeastCell, (svg::width_of(style) - kNames - kRight) /
                                                           static_cast<double>(columns))
                                : 84;
  std::vector<double> values;
  for (const DescriptorMap& map : maps)
    for (const auto& row : map.fields)
      for (const MapField& field : row)
        if (field.cell.estimate) values.push_back(*field.cell.estimate);
  std::string content;
  double top = kMargin, width = 0;
  for (const DescriptorMap& map : maps) {
    const Axis axis = axis_of(map.column.info, values);
    const auto rows = static_cast<double>(map.rows.size());
    content += text(10, top - 14, "start",
                    svg::label_of(style, map.method) + ": " + label_of(map.column.info)) +
               text(10, top + 4, "start", label_of(map.row_descriptor));
    for (std::size_t row = 0; row < map.rows.size(); ++row) {
      const double y = top + 12 + kCellHeight * (rows - 1 - static_cast<double>(row));  // upwards
      content += text(kNames - 8, y + 24, "end", map.rows[row].label());
      for (std::size_t column = 0; column < map.columns.size(); ++column) {
        const Cell& cell = map.fields[row][column].cell;
        const double x = kNames + cell_width * static_cast<double>(column);
        const double shade = cell.estimate ? 0.55 * axis.part(*cell.estimate) : 0;
        content += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.0f}\" height=\"{:.0f}\" "
            "fill=\"#008060\" fill-opacity=\"{:.2f}\" stroke=\"#999\" stroke-width=\"0.5\"/>",
            x, y, cell_width, kCellHeight, shade);
        content += text(x + cell_width / 2, y + 17, "middle",
                        cell.estimate ? fmt::format("{:.3g}", *cell.estimate) : "–") +
                   text(x + cell_width / 2, y + 33, "middle", fmt::format("n = {}", cell.n));
      }
    }
    const double bottom = top + 12 + kCellHeight * rows;
    for (std::size_t column = 0; column < map.columns.size(); ++column)
      content += text(kNames + cell_width * (static_cast<double>(column) + 0.5), bottom + 16,
                      "middle", map.columns[column].label());
    const double right = kNames + cell_width * static_cast<double>(map.columns.size());
    content += text((kNames + right) / 2, bottom + 34, "middle", label_of(map.column_descriptor));
    width = std::max(width, right + kRight);
    top = bottom + kPanel;
  }
  return document(width, top - kPanel + kMargin, content, style);
}

std::string difficulty_figure(const DifficultyScale& scale, const std::vector<std::string>& methods,
                              const FigureStyle& style) {
  const Plot plot(style);
  std::vector<double> ends;
  for (const MethodAbility& method : scale.methods) {
    if (method.ability) ends.push_back(*method.ability);
    if (method.interval) ends.insert(ends.end(), {method.interval->low, method.interval->high});
  }
  for (const double difficulty : scale.by_solvers) ends.push_back(difficulty);
  QuantityInfo info;
  info.name = "ability of methods, difficulty of scenarios";
  info.unit = "logit";
  const Axis axis = axis_of(info, ends);
  std::vector<std::size_t> scenarios(scale.by_solvers.size());
  for (const ScenarioDifficulty& one : scale.scenarios) ++scenarios[one.solved_by];
  const std::size_t most =
      scenarios.empty() ? 0 : *std::max_element(scenarios.begin(), scenarios.end());
  std::string content = plot.frame("scenarios", label_of(info)) + y_ticks(plot, axis);
  for (std::size_t solvers = 0; solvers < scenarios.size(); ++solvers) {
    if (scenarios[solvers] == 0) continue;
    const double y = plot.y(axis.part(scale.by_solvers[solvers]));
    const double part = static_cast<double>(scenarios[solvers]) / static_cast<double>(most);
    content += segment(plot.x(0), y, plot.x(0.8 * part), y, 5, "#9aa5b1") +
               text(plot.x(0.8 * part) + 5, y + 4, "start", std::to_string(scenarios[solvers]));
  }
  for (std::size_t i = 0; i < scale.methods.size(); ++i) {
    const MethodAbility& method = scale.methods[i];
    const auto named = std::find(methods.begin(), methods.end(), method.method);
    const std::string color = method_color(static_cast<std::size_t>(named - methods.begin()));
    content +=
        legend(plot, i,
               svg::label_of(style, method.method) + (method.ability ? "" : " (no finite ability)"),
               color);
    if (!method.ability) continue;
    const double x =
        plot.x(0.86 + 0.12 * static_cast<double>(i) /
                          static_cast<double>(std::max<std::size_t>(scale.methods.size() - 1, 1)));
    content += point(x, plot.y(axis.part(*method.ability)), 3, color);
    if (method.interval)
      content += segment(x, plot.y(axis.part(method.interval->low)), x,
                         plot.y(axis.part(method.interval->high)), 1.2, color);
  }
  return plot.document(content, scale.methods.size());
}

std::string outcome_figure(const SummaryTable& summary, const FigureStyle& style) {
  constexpr double kBar = 16, kLeastNames = 110, kCounts = 80, kKeys = 24, kLeast = 120;
  double names = kLeastNames;
  for (const MethodSummary& method : summary.methods)
    names = std::max(names, svg::width_of_text(svg::label_of(style, method.method)) + 12);
  const double figure = style.width ? svg::width_of(style) : names + 360 + kCounts;
  const double width = std::max(kLeast, figure - names - kCounts);
  std::string content;
  double key = names, keys = kKeys;
  for (const std::string& outcome : summary.outcomes) {
    const double needed = 30 + 7 * static_cast<double>(outcome.size());
    if (key > names && key + needed > figure) {
      key = names;
      keys += kLine;
    }
    content += segment(key, keys, key + 14, keys, 8, outcome_color(outcome)) +
               text(key + 18, keys + 4, "start", outcome);
    key += needed;
  }
  double top = keys + kMargin - kKeys;
  for (const MethodSummary& method : summary.methods) {
    content += text(names - 8, top + 12, "end", svg::label_of(style, method.method));
    double done = 0;
    for (const std::string& outcome : summary.outcomes) {
      const auto found = method.outcomes.find(outcome);
      if (found == method.outcomes.end()) continue;
      const double part = static_cast<double>(found->second) / static_cast<double>(method.n);
      content += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.0f}\" fill=\"{}\"/>",
          names + width * done, top, width * part, kBar, outcome_color(outcome));
      done += part;
    }
    content += text(names + width + 6, top + 12, "start", fmt::format("n = {}", method.n));
    top += 26;
  }
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0})
    content += segment(names + width * part, top, names + width * part, top + 5) +
               text(names + width * part, top + 18, "middle", fmt::format("{:g}", part));
  return document(names + width + kCounts, top + 30, content, style);
}

std::string box_figure(const ResultTable& runs, const std::string& metric,
                       const FigureStyle& style) {
  const Plot plot(style);
  const RunValues values(runs, metric);
  const std::vector<MethodValues> methods = values_by_method(runs, values);
  const Axis axis = axis_of(values.info(), all_of(methods));
  const auto y_of = [&](double value) { return plot.y(axis.part(value)); };
  std::string content = plot.frame("", label_of(values.info())) + y_ticks(plot, axis);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(methods.size()),
                 x = plot.x(part),
                 half = std::min(14.0, 0.3 * plot.width() / static_cast<double>(methods.size()));
    const std::string color = method_color(i);
    content += legend(plot, i,
                      fmt::format("{} (n = {} of {})", svg::label_of(style, runs.methods[i]),
                                  methods[i].values.size(), methods[i].runs),
                      color);
    if (methods[i].values.empty()) continue;
    const auto at = [&](double fraction) { return y_of(quantile(methods[i].values, fraction)); };
    content += segment(x, at(0.05), x, at(0.95), 1.2, color) +
               fmt::format(
                   "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                   "fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.5\"/>",
                   x - half, at(0.75), 2 * half, at(0.25) - at(0.75), color) +
               segment(x - half, at(0.5), x + half, at(0.5), 2.5, color);
  }
  return plot.document(content, methods.size());
}

std::string distribution_figure(const ResultTable& runs, const std::string& metric,
                                const FigureStyle& style) {
  const Plot plot(style);
  const RunValues values(runs, metric);
  const std::vector<MethodValues> methods = values_by_method(runs, values);
  const Axis axis = axis_of({values.info().id, 1, "", "", Direction::None}, all_of(methods));
  std::string content = plot.frame(label_of(values.info()), "share of runs") + x_ticks(plot, axis) +
                        y_ticks(plot, {});
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::string points = fmt::format("{:.1f},{:.1f} ", plot.x(0), plot.y(0));
    double share = 0;
    for (std::size_t k = 0; k < methods[i].values.size(); ++k) {
      const double x = plot.x(axis.part(methods[i].values[k]));
      points += fmt::format("{:.1f},{:.1f} ", x, plot.y(share));
      share = static_cast<double>(k + 1) / static_cast<double>(methods[i].runs);
      points += fmt::format("{:.1f},{:.1f} ", x, plot.y(share));
    }
    points += fmt::format("{:.1f},{:.1f}", plot.x(1), plot.y(share));
    content += svg::method_line(points, i) + svg::method_key(plot, i, runs.methods[i]);
  }
  return plot.document(content, methods.size());
}

std::string scatter_figure(const ResultTable& runs, const std::string& x, const std::string& y,
                           const FigureStyle& style) {
  const Plot plot(style);
  const RunValues horizontal(runs, x), vertical(runs, y);
  std::vector<double> xs, ys;
  for (std::size_t run = 0; run < runs.size(); ++run)
    if (!horizontal.is_na(run) && !vertical.is_na(run)) {
      xs.push_back(horizontal(run));
      ys.push_back(vertical(run));
    }
  const Axis x_axis = axis_of(horizontal.info(), xs), y_axis = axis_of(vertical.info(), ys);
  std::string content = plot.frame(label_of(horizontal.info()), label_of(vertical.info())) +
                        x_ticks(plot, x_axis) + y_ticks(plot, y_axis);
  for (std::size_t run = 0; run < runs.size(); ++run)
    if (!horizontal.is_na(run) && !vertical.is_na(run))
      content += point(plot.x(x_axis.part(horizontal(run))), plot.y(y_axis.part(vertical(run))),
                       2.5, method_color(runs.method[run]), 0.55);
  for (std::size_t i = 0; i < runs.methods.size(); ++i)
    content += legend(plot, i, svg::label_of(style, runs.methods[i]), method_color(i));
  return plot.document(content, runs.methods.size());
}

}  // namespace slalom
