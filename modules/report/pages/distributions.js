// SPDX-License-Identifier: BSD-3-Clause
// Distributions of a metric by method: cumulative fractions, boxes, proportions, and runs over a second quantity.
"use strict";

// An axis from the least to the greatest of `values`, with round ticks.
function rangeAxis(label, values) {
  const numbers = values.filter((value) => typeof value === "number");
  let low = Infinity, high = -Infinity;
  for (const value of numbers) { low = Math.min(low, value); high = Math.max(high, value); }
  if (numbers.length === 0) [low, high] = [0, 1];
  const margin = high > low ? 0.02 * (high - low) : 0.5, axis = { label, low: low - margin, high: high + margin };
  const ticks = ticksOf(axis), step = ticks.length > 1 ? ticks[1] - ticks[0] : 1;
  return Object.assign(axis, { ticks, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-6)) });
}

const axisLabel = (quantity) => quantity.name + unitText(quantity);

// The fraction of the values that are at most x, per method.
function cumulativeChart(quantity, groups) {
  const x = rangeAxis(axisLabel(quantity), groups.flatMap(({ sorted }) => sorted));
  const series = groups.filter(({ n }) => n > 0).map(({ method, sorted, n }) => ({
    label: `${methodLabel(method)} (n=${n})`, color: report.methods[method].color, steps: true,
    points: [[x.low, 0], ...sorted.map((value, i) => [value, (i + 1) / n])] }));
  return [chart(x, fractionAxis("fraction of the values that are at most x"), series), legend(series)];
}

// A box from the first to the third quartile with the median, whiskers from the 5 % to the 95 % quantile, per method, and
// all runs below it.
function boxChart(quantity, values, groups) {
  const row = 62, x = rangeAxis(axisLabel(quantity), groups.flatMap(({ sorted }) => sorted));
  const height = CHART.top + CHART.bottom + row * groups.length;
  const picture = chart(x, { label: "", low: 0, high: 1, ticks: [], digits: 0 }, [], height), points = [];
  groups.forEach(({ method, runs, quantiles }, i) => {
    const top = CHART.top + row * i, middle = top + 26, { name, color } = report.methods[method];
    picture.append(label(CHART.left + 4, top + 10, "start", name));
    if (!quantiles) return;
    const [low, first, median, third, high] = quantiles.map(picture.toX);
    picture.append(line("axis", low, middle, high, middle),
      svg("rect", { x: first, y: middle - 9, width: Math.max(1, third - first), height: 18, fill: color, "fill-opacity": 0.45, stroke: color }),
      line("median", median, middle - 11, median, middle + 11));
    runs.forEach((run, at) => points.push({ run, x: picture.toX(values[run]), y: middle + 17 + (at * 7) % 13 }));
  });
  return { picture, points };
}

// The fraction of the values that are 1, per method, as a bar.
function proportionChart(groups) {
  const row = 44, x = { label: "fraction of the values that are 1", low: 0, high: 1 };
  const picture = chart(x, { label: "", low: 0, high: 1, ticks: [], digits: 0 }, [], CHART.top + CHART.bottom + row * groups.length);
  groups.forEach(({ method, mean, n }, i) => {
    const top = CHART.top + row * i;
    picture.append(label(CHART.left + 4, top + 12, "start", `${methodLabel(method)}: ${countText({ mean, n })}`));
    if (n > 0)
      picture.append(svg("rect", { x: CHART.left, y: top + 18, width: Math.max(1, picture.toX(mean) - CHART.left), height: 16,
                                   fill: report.methods[method].color }));
  });
  return picture;
}

// Runs by the quantity `across` and `quantity`; those without a value of the latter are in a strip at the bottom.
function scatterChart(quantity, values, across, positions, runs) {
  const strip = 26, height = 380, x = rangeAxis(axisLabel(across), runs.map((run) => positions[run]));
  const y = rangeAxis(axisLabel(quantity), runs.map((run) => values[run])), bottom = height - CHART.bottom;
  const low = y.low - ((y.high - y.low) * strip) / (bottom - CHART.top - strip);
  const picture = chart(x, Object.assign({}, y, { low }), [], height);
  const toY = (value) => bottom - ((value - low) / (y.high - low)) * (bottom - CHART.top);
  picture.append(line("rule", CHART.left, bottom - strip, CHART.width - CHART.right, bottom - strip),
                 label(CHART.left - 6, bottom - strip / 2 + 4, "end", "NA"));
  const points = runs.filter((run) => typeof positions[run] === "number").map((run) => ({ run, x: picture.toX(positions[run]),
    y: typeof values[run] === "number" ? toY(values[run]) : bottom - strip + 6 + (run * 5) % (strip - 10) }));
  return { picture, points };
}
