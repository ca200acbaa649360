// SPDX-License-Identifier: BSD-3-Clause
// Statistics that the pages compute themselves from the values of runs: counts, means, quantiles, and intervals of rates.
// Other intervals and tests come with the report.
"use strict";

// Linear between the order statistics of `sorted`, as in slalom-analyze.
function quantile(sorted, fraction) {
  const at = fraction * (sorted.length - 1), low = Math.floor(at), high = Math.min(low + 1, sorted.length - 1);
  return sorted[low] + (at - low) * (sorted[high] - sorted[low]);
}

// Describes a field of runs (indexes): the runs with values in increasing order of these, their mean and five
// quantiles, and the numbers of missing values by reason.
function describe(runs, values) {
  const present = runs.filter((run) => typeof values[run] === "number").sort((a, b) => values[a] - values[b]);
  const sorted = present.map((run) => values[run]), na = {};
  for (const run of runs) if (typeof values[run] !== "number") na[values[run]] = (na[values[run]] || 0) + 1;
  const mean = sorted.length > 0 ? sorted.reduce((sum, value) => sum + value, 0) / sorted.length : null;
  const quantiles = sorted.length > 0 ? [0.05, 0.25, 0.5, 0.75, 0.95].map((fraction) => quantile(sorted, fraction)) : null;
  return { runs: present, sorted, n: sorted.length, mean, quantiles, na };
}

// Wilson's interval of the rate of a group that describe() made, for runs (indexes) each in a scenario of its own, as in
// slalom-analyze; null for others, whose runs are not independent, and without values.
function rateInterval({ runs, n, mean }) {
  if (n === 0 || report.selected || new Set(runs.map((run) => report.runs[run][0])).size < n) return null;
  const z = report.z, center = (mean + (z * z) / (2 * n)) / (1 + (z * z) / n);
  const half = (z / (1 + (z * z) / n)) * Math.sqrt((mean * (1 - mean)) / n + (z * z) / (4 * n * n));
  return [Math.max(0, center - half), Math.min(1, center + half)];
}

const inBin = (bin) => (value) => typeof value === "number" && (bin.low === null || value >= bin.low) &&
  (bin.high === null || value < bin.high || (bin.high_included && value === bin.high));
