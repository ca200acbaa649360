// SPDX-License-Identifier: BSD-3-Clause
// The pictures of failures, and what method.html begins with: a sentence, the outcomes, the failures worth looking at.
"use strict";

// Called by data/failures.js: pictures by the index of their run.
function slalomFailures(pictures) {
  document.querySelectorAll("[data-failure]").forEach((node) => {
    const picture = pictures[node.dataset.failure];
    if (picture) node.innerHTML = picture;
  });
}

function failureFigure({ run, why }) {
  const [scenario, method, repetition, outcome] = report.runs[run], { hash, name } = report.scenarios[scenario];
  return html("figure", {}, html("a", { href: "run.html#" + runId(hash, report.methods[method].name, repetition), title: why,
                                        "aria-label": `${methodLabel(method)} in ${name}: ${why}` },
    html("div", { class: "picture", "data-failure": String(run) }), html("span", { class: "support" }, name)),
    html("span", { class: "support" }, why));
}

// Success over the bins of the first descriptor, on a scale from 0 to 1, with its intervals; null without bins.
function sparkline(method) {
  const at = report.columns.findIndex((column) => column.id === "success");
  const group = report.tables.find(({ methods }) => methods.some((table) => table.method === method && table.rows.length > 1));
  if (at < 0 || !group || report.selected) return null;
  const table = group.methods.find((one) => one.method === method), points = table.rows.map(({ bin, cells }, i) => ({ bin, cell: cells[at], i }))
    .filter(({ cell }) => cell.mean !== null);
  const width = 160, height = 48, x = (i) => ((i + 0.5) * width) / table.rows.length, y = (value) => 3 + (1 - value) * (height - 6);
  const label = points.map(({ bin, cell }) => `${bin}: ${fixed(cell.mean, 2)} ${intervalText(cell.interval, 2)} (${countText(cell)})`);
  return html("figure", { class: "sparkline" },
    svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": `success by ${group.descriptor.id}: ${label.join(", ")}` },
      svg("title", {}, label.join("\n")),
      [0, 1].map((value) => svg("line", { class: "axis", x1: 0, x2: width, y1: y(value), y2: y(value) })),
      points.filter(({ cell }) => cell.interval).map(({ cell, i }) =>
        svg("line", { x1: x(i), x2: x(i), y1: y(cell.interval[0]), y2: y(cell.interval[1]) })),
      svg("polyline", { points: points.map(({ cell, i }) => x(i).toFixed(1) + "," + y(cell.mean).toFixed(1)).join(" ") }),
      points.map(({ cell, i }) => svg("circle", { cx: x(i), cy: y(cell.mean), r: 2.5 }))),
    html("figcaption", { class: "support" }, `success, 0 to 1, by ${group.descriptor.name.toLowerCase()} → `));
}

function overviewCard({ method, text, failures, in_common }) {
  const name = methodLabel(method), row = report.summary.find((one) => one.method === method);
  const link = html("a", { href: "method.html#" + (method + 1) }, name);
  const rest = text.startsWith(name) ? text.slice(name.length) : ": " + text;
  return html("div", { class: "card overview" },
    html("div", {}, sparkline(method), html("p", {}, swatch(report.methods[method].color), link, rest + "."),
             in_common ? html("p", {}, html("strong", {}, `${in_common.runs} of ${in_common.failures} failures`), " " + in_common.text) : null, outcomeBar(row)),
    failures.length > 0 ? html("div", { class: "failures" }, failures.map(failureFigure))
      : row.outcomes.some((n, i) => n > 0 && report.outcomes[i] !== "success") ? soft("No other method solves a scenario in which it fails.") : "");
}

function overviewSection(method) {
  const entries = report.overview.filter((one) => one.method === method);
  const headlines = report.headlines.filter((one) => one.method === method)
    .map(({ text }) => html("p", { class: "headline" }, html("strong", {}, text + (text.endsWith("?") ? "" : "."))));
  if (entries.length === 0) return headlines.length === 0 ? null : headlines;
  loadScript("data/failures.js");
  return [headlines, entries.map(overviewCard),
          soft("Trends, and differences on the same scenarios, only where a corrected test shows them. Pictures: at most three " +
               "failures of each method in scenarios that others solve; where most do first, then collisions. A click opens the replay.")];
}

// Metrics on the scenarios in which all methods have a value, where means over all runs are not comparable.
function commonSection() {
  if (report.common_scenarios.length === 0) return null;
  const scales = report.common_scenarios.map(({ metric, methods }) =>
    scaleOf(report.columns.find((column) => column.id === metric), methods.map(({ cell }) => cell)));
  const head = report.common_scenarios.map(({ metric, scenarios, left_out }) =>
    html("th", {}, metric, html("br"), html("span", { class: "support" }, `on ${scenarios} of ${plural(scenarios + left_out, "scenario")}`)));
  const line = (_, i) => html("tr", {}, html("th", { class: "name" }, methodName(i)),
    report.common_scenarios.map(({ methods }, at) => tableCell(methods[i].cell, scales[at], methods[i].runs)));
  return card(html("h3", { class: "title" }, "On the scenarios that all methods solved"),
              tableOf({}, [heading("Method"), head], report.methods.map(line)));
}
