// SPDX-License-Identifier: BSD-3-Clause
// Charts as SVG; the colors of text and axes follow the style sheet, for print and dark mode.
"use strict";

const CHART = { width: 640, left: 52, right: 14, top: 26, bottom: 42 };

const line = (name, x1, y1, x2, y2) =>
  svg("line", { class: name, x1: x1.toFixed(1), y1: y1.toFixed(1), x2: x2.toFixed(1), y2: y2.toFixed(1) });
const label = (x, y, anchor, text) => svg("text", { x: x.toFixed(1), y: y.toFixed(1), "text-anchor": anchor }, text);

// Multiples of 1, 2 or 5 times a power of ten; powers of two on a logarithmic axis.
function ticksOf(axis) {
  const ticks = [], span = axis.high - axis.low;
  if (axis.logarithmic) for (let tick = axis.low; tick <= axis.high * 1.0001; tick *= 2) ticks.push(tick);
  if (axis.logarithmic || !(span > 0)) return ticks.length ? ticks : [axis.low];
  const power = 10 ** Math.floor(Math.log10(span));
  const step = span / power > 5 ? power : span / power > 2 ? power / 2 : power / 5;
  for (let tick = Math.ceil(axis.low / step) * step; tick <= axis.high + step / 1000; tick += step) ticks.push(tick);
  return ticks;
}

function seriesPath(series, toX, toY, end) {
  const step = (x, y) => `H${x}V${y}`, straight = (x, y) => `L${x} ${y}`;
  const path = series.points.map(([x, y], i) => {
    const at = [toX(x).toFixed(1), toY(y).toFixed(1)];
    return i === 0 ? `M${at[0]} ${at[1]}` : (series.steps ? step : straight)(...at);
  });
  return path.join("") + (series.steps ? "H" + end.toFixed(1) : "");
}

// Axes have label, low and high, x may be logarithmic or have its ticks, y has its ticks and their digits. Each of
// `series` has label, color and points [x, y] by increasing x; with `steps`, each value holds until the next point, the
// last one until the right border. The chart's property toX maps values to its coordinates.
function chart(x, y, series, height = 300) {
  const right = CHART.width - CHART.right, bottom = height - CHART.bottom;
  const along = (value) => (x.logarithmic ? Math.log(value) : value), span = along(x.high) - along(x.low);
  const fraction = (value) => (span > 0 ? Math.min(1, Math.max(0, (along(value) - along(x.low)) / span)) : 0);
  const toX = (value) => CHART.left + fraction(value) * (right - CHART.left);
  const toY = (value) => bottom - ((value - y.low) / (y.high - y.low)) * (bottom - CHART.top);
  const picture = svg("svg", { class: "chart", viewBox: `0 0 ${CHART.width} ${height}`, role: "img" },
    svg("title", {}, y.label), label(6, 14, "start", y.label),
    y.ticks.map((tick) => [line("rule", CHART.left, toY(tick), right, toY(tick)),
                           label(CHART.left - 6, toY(tick) + 4, "end", tick.toFixed(y.digits))]),
    (x.ticks || ticksOf(x)).map((tick) => [line("axis", toX(tick), bottom, toX(tick), bottom + 4),
                                           label(toX(tick), bottom + 17, "middle", String(Number(tick.toPrecision(4))))]),
    label((CHART.left + right) / 2, height - 8, "middle", x.label), line("axis", CHART.left, bottom, right, bottom),
    series.filter((one) => one.points.length > 0).map((one) =>
      svg("path", { d: seriesPath(one, toX, toY, right), fill: "none", stroke: one.color, "stroke-width": 2 },
          svg("title", {}, one.label))));
  picture.toX = toX;
  return picture;
}

const swatch = (color) => html("i", { class: "swatch", style: "background:" + color });
const legend = (series) =>
  html("div", { class: "legend" }, series.map((one) => html("span", {}, swatch(one.color), one.label)));

// A y axis for fractions.
const fractionAxis = (text) => ({ label: text, low: 0, high: 1, ticks: [0, 0.25, 0.5, 0.75, 1], digits: 2 });

// A y axis with 0 and all values whose ends are exactly those that its labels name: multiples of 1, 2 or 5 times a
// power of ten, which is a quarter of the range or less.
function axisOf(text, values) {
  const low = Math.min(0, ...values), high = Math.max(0.1, ...values), quarter = (high - low) / 4;
  const power = Math.floor(Math.log10(quarter)), factor = quarter / 10 ** power;
  const step = (factor >= 5 ? 5 : factor >= 2 ? 2 : 1) * 10 ** power;
  const outwards = (value) => (value < 0 ? Math.floor(value / step + 1e-6) : Math.ceil(value / step - 1e-6)) * step;
  const ends = [outwards(low), outwards(high)];
  return { label: text, low: ends[0], high: ends[1], ticks: ends, digits: Math.max(0, -power) };
}

// Critical-difference diagram (Demsar 2006): methods, each with label, color and rank, on a scale of mean ranks, 1 at
// the left; bars join the methods of each of `groups` (indexes, best first).
function rankDiagram(methods, groups, criticalDifference) {
  const n = methods.length, scale = 52, first = scale + 9 * groups.length + 20;
  const x = (rank) => 40 + (n > 1 ? (rank - 1) / (n - 1) : 0) * (CHART.width - 260);
  const end = x(Math.min(n, 1 + criticalDifference));
  const sorted = methods.slice().sort((a, b) => a.rank - b.rank);
  return svg("svg", { class: "chart", viewBox: `0 0 ${CHART.width} ${first + 18 * n}`, role: "img" },
    svg("title", {}, "Mean ranks of the methods"), line("axis", x(1), scale, x(n), scale),
    methods.map((_, i) => [line("axis", x(i + 1), scale - 5, x(i + 1), scale), label(x(i + 1), scale - 9, "middle", String(i + 1))]),
    line("bar", x(1), 16, end, 16), label(end + 8, 20, "start", "critical difference " + fixed(criticalDifference, 2)),
    groups.map((group, i) => line("bar", x(methods[group[0]].rank) - 4, scale + 8 + 9 * i,
                                  x(methods[group[group.length - 1]].rank) + 4, scale + 8 + 9 * i)),
    sorted.map(({ label: name, color, rank }, i) => [line("rule", x(rank), scale, x(rank), first + 18 * i),
      svg("circle", { cx: x(rank).toFixed(1), cy: (first + 18 * i).toFixed(1), r: 4, fill: color }),
      label(x(rank) + 9, first + 18 * i + 4, "start", name + "  " + fixed(rank, 2))]));
}
