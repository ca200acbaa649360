// SPDX-License-Identifier: BSD-3-Clause
// Distributions of a metric by method: over bins, cumulative fractions, boxes, and runs over a second quantity.
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

const isRate = (quantity) => quantity.kind === "rate";
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

// The ends of what is drawn around the value of a group: the interval of a rate, where it is known, or the quartiles.
const spreadOf = (group, rate) => (rate ? group.interval : group.quantiles && [group.quantiles[1], group.quantiles[3]]);

// A line per method over the bins: the proportion of a rate with its interval, or the median with the quartiles. `groups`
// has those of each bin by method.
function binChart(quantity, across, titles, groups, methods) {
  const rate = isRate(quantity), valueOf = (group) => (rate ? group.mean : group.quantiles && group.quantiles[2]);
  const drawn = groups.flat().filter((group) => group.n > 0);
  const y = rate ? fractionAxis("fraction of the runs") : rangeAxis("median, quartiles", drawn.flatMap((group) => spreadOf(group, rate)));
  const x = { label: axisLabel(across), low: 0, high: titles.length, ticks: [] };
  const place = (bin, at) => bin + 0.5 + ((at - (methods.length - 1) / 2) * 0.5) / Math.max(methods.length, 4);
  const series = methods.map((method, at) => ({ label: methodLabel(method), color: report.methods[method].color,
    points: groups.map((row, bin) => [place(bin, at), valueOf(row[at])]).filter(([, value]) => value !== null) }));
  const picture = chart(x, y, series, 340), bottom = 340 - CHART.bottom;
  const toY = (value) => bottom - ((value - y.low) / (y.high - y.low)) * (bottom - CHART.top);
  titles.forEach((title, bin) => picture.append(label(picture.toX(bin + 0.5), bottom + 17, "middle", title)));
  groups.forEach((row, bin) => row.forEach((group, at) => {
    if (group.n === 0) return;
    const cx = picture.toX(place(bin, at)), spread = spreadOf(group, rate), stroke = series[at].color, text = (value) => fixed(value, rate ? 2 : 3);
    picture.append(svg("g", { stroke, "stroke-width": 1.6 },
      svg("title", {}, `${series[at].label}, ${titles[bin]}: ${text(valueOf(group))}${spread ? " [" + spread.map(text).join(", ") + "]" : ""}, ` +
                       (rate ? countText(group) : "n=" + group.n)),
      spread ? svg("line", { x1: cx, x2: cx, y1: toY(spread[0]), y2: toY(spread[1]) }) : null,
      svg("circle", { cx, cy: toY(valueOf(group)), r: 4, fill: stroke })));
  }));
  return [picture, legend(series)];
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
