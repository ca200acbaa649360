// SPDX-License-Identifier: BSD-3-Clause
// Cells of tables: digits, shades, whiskers, reasons of missing values; small builders of cards and texts.
"use strict";

// Cells with fewer values get neither shade nor whisker: they would dominate the column's scale.
const enoughToDraw = (cell) => cell.n >= 5;

// The interval of a cell with its estimate: of the median where the mean has none.
const stated = (cell) => (cell.median_interval ? { estimate: cell.median, interval: cell.median_interval }
                                               : { estimate: cell.mean, interval: cell.interval });

// More than a tenth of the runs have no value: the mean describes the others only, such as those that succeeded.
const survivorsOnly = (cell) => cell.n > 0 && 10 * missing(cell) > cell.n + missing(cell);

// Three significant digits of the largest number.
function digitsOf(cells, column) {
  const largest = Math.max(0, ...cells.map((cell) => Math.abs(cell.mean || 0)));
  return column.rate || largest === 0 ? 2 : Math.min(4, Math.max(0, 2 - Math.floor(Math.log10(largest))));
}

// The common scale of the cells of a column: `low` and `high` of whiskers, `worst` and `best` of shades.
function scaleOf(column, cells) {
  const rateEnds = column.direction === "down" ? { worst: 1, best: 0 } : { worst: 0, best: 1 };
  const scale = { column, digits: digitsOf(cells, column), low: 0, high: 1, ...rateEnds };
  const drawn = cells.filter(enoughToDraw), means = drawn.filter((cell) => !survivorsOnly(cell)).map((cell) => cell.mean);
  if (column.rate || drawn.length === 0) return scale;
  const intervals = drawn.map((cell) => stated(cell).interval).filter((interval) => interval);
  scale.low = Math.min(...intervals.map((interval) => interval[0]));
  scale.high = Math.max(...intervals.map((interval) => interval[1]));
  const ends = [Math.min(...means), Math.max(...means)];
  [scale.worst, scale.best] = column.direction === "down" ? ends.reverse() : ends;
  return scale;
}

const goodness = (mean, { worst, best }) => (best === worst ? 0.5 : (mean - worst) / (best - worst));
const numberText = (number, digits) => (Math.abs(number) < 1e9 ? fixed(number, digits) : String(number));
const intervalText = (interval, digits) =>
  interval ? `[${numberText(interval[0], digits)}, ${numberText(interval[1], digits)}]` : "";
const missing = (cell) => Object.values(cell.na).reduce((sum, n) => sum + n, 0);
const valuesText = (cell) => "n = " + cell.n + (missing(cell) ? " of " + (cell.n + missing(cell)) : "");
const reasonsText = (na) => Object.entries(na).map(([reason, n]) => n + " " + reason).join(", ");
const support = (...children) => html("span", { class: "support" }, ...children);

// "3/4": how many of the values of a rate are 1.
const countText = ({ mean, n }) => Math.round((mean || 0) * n) + "/" + n;

function supportText(cell, column, digits) {
  if (column.rate && cell.mean !== null)
    return countText(cell) + (missing(cell) ? " NA=" + missing(cell) : "");
  return (cell.median_interval ? `median ${numberText(cell.median, digits)} ${intervalText(cell.median_interval, digits)} ` : "") +
    (cell.deviation === null ? "" : "±" + numberText(cell.deviation, digits) + " ") + valuesText(cell);
}

// The estimate as a dot on its interval.
function whisker(cell, { low, high }) {
  const { estimate, interval } = stated(cell);
  if (!enoughToDraw(cell) || !interval || high <= low) return null;
  const x = (value) => (4 + (112 * (value - low)) / (high - low)).toFixed(1);
  const bar = (name, from, to) => svg("line", { class: name, x1: from, x2: to, y1: 4.5, y2: 4.5 });
  return svg("svg", { class: "whisker", viewBox: "0 0 120 9", preserveAspectRatio: "xMinYMid", "aria-hidden": "true" },
    bar("axis", 4, 116), bar(null, x(interval[0]), x(interval[1])),
    svg("circle", { cx: x(estimate), cy: 4.5, r: 3 }));
}

const runsLink = (group) => "runs.html#cell-" + group;

// `shade` from 0 to 1, null for none.
function cellNode(cell, group, digits, shade, below) {
  const title = missing(cell) ? "missing: " + reasonsText(cell.na) + (survivorsOnly(cell)
    ? "; not shaded: more than 10 % of the runs have no value, the mean is that of the others" : "") : null;
  return html("td", { class: cell.mean === null ? "cell na" : "cell", title,
                      style: shade === null ? null : "--g:" + shade.toFixed(2) },
    html("a", { class: "big", href: runsLink(group) }, cell.mean === null ? "–" : numberText(cell.mean, digits)),
    html("span", { class: "interval" }, intervalText(cell.interval, digits)), below);
}

function tableCell(cell, scale, group) {
  const shaded = scale.column.direction !== "none" && cell.mean !== null && enoughToDraw(cell) && !survivorsOnly(cell);
  return cellNode(cell, group, scale.digits, shaded ? goodness(cell.mean, scale) : null,
                  [whisker(cell, scale), support(supportText(cell, scale.column, scale.digits))]);
}

// Leads to the page that explores the metric, by the quantity `by` if it is not empty.
function headerCell(column, by) {
  const arrow = { up: " ↑", down: " ↓", none: "" }[column.direction];
  return html("th", {}, html("a", { href: "explore.html" + addressOf("", { metric: column.id, by }) }, column.name), arrow + unitText(column),
              html("br"), html("code", {}, column.id),
              column.wall_clock ? [html("br"), "wall clock"] : null);
}

const tableOf = (attributes, header, rows) =>
  oneTabStop(html("table", attributes, html("thead", {}, html("tr", {}, header)), html("tbody", {}, rows)));
const card = (...children) => html("div", { class: "card" }, ...children);
const soft = (...children) => html("p", { class: "soft" }, ...children);
const heading = (text) => html("th", {}, text);
const methodLabel = (index) => report.methods[index].label || report.methods[index].name;  // with the mark if it is privileged
const methodName = (index) => [swatch(report.methods[index].color), methodLabel(index)];
const finding = (text, shown) => html("p", { class: shown ? "finding shown" : "finding soft" }, text);
