// SPDX-License-Identifier: BSD-3-Clause
// The gallery of scenarios: pictures, outcomes, values.
"use strict";

function galleryLegend() {
  const sample = (attributes) => svg("svg", { width: 34, height: 10, "aria-hidden": "true" },
    svg("line", { x1: 1, y1: 5, x2: 33, y2: 5, stroke: "currentColor", "stroke-width": 1.5, ...attributes }));
  const item = (...children) => html("span", {}, ...children);
  return html("div", { class: "legend" },
    report.methods.map(({ name, color }) => item(sample({ stroke: color, "stroke-width": 3 }), name)),
    item(sample({ "stroke-dasharray": "7 3" }), "shortest path"), item(sample({ "stroke-dasharray": "2 3" }), "safest path"),
    report.outcomes.map(markItem), ["○ with a dash: start", "⊕ goal"].map((text) => item(text)));
}

// A row per run with its outcome and the values of two columns.
function outcomesTable(runs, hash) {
  const columns = report.columns.map((column, i) => [column, i]).filter(([column]) => !column.rate && !column.wall_clock).slice(0, 2);
  const value = (run, index) => {
    const number = run[5 + index];
    return typeof number === "number" ? html("td", {}, fixed(number, 2)) : html("td", { class: "na", title: number }, "–");
  };
  const line = (run) => html("tr", {},
    html("th", {}, swatch(report.methods[run[1]].color),
         html("a", { href: "run.html#" + runId(hash, report.methods[run[1]].name, run[2]) },
              methodLabel(run[1]) + (run[2] > 0 ? " #" + run[2] : ""))),
    html("td", {}, outcomeChip(report.outcomes[run[3]], 0, run[4])), columns.map(([, index]) => value(run, index)));
  return tableOf({}, ["", "", ...columns.map(([column]) => column.id)].map(heading), runs.map(line));
}

function figureOf(scenario, runs) {
  const value = (number, { id, unit }) => [html("dt", {}, id), typeof number === "number"
    ? html("dd", {}, fixed(number, 3) + (unit === "-" ? "" : " " + unit)) : html("dd", { class: "na" }, "NA: " + number)];
  return html("figure", { id: "s-" + scenario.hash }, html("h3", { class: "title" }, scenario.name), html("div", { class: "picture" }),
    html("figcaption", {}, outcomesTable(runs, scenario.hash),
         html("dl", { class: "values" }, scenario.values.map((number, i) => value(number, report.descriptors[i])))));
}

// Called by data/pictures-PAGE.js: the pictures of the scenarios of a page, in their order.
function slalomPictures(page, pictures) {
  report.scenarios.filter((scenario) => scenario.page === page).forEach(({ hash }, i) => {
    const figure = element("s-" + hash);
    if (figure) figure.querySelector(".picture").innerHTML = pictures[i];
  });
  if (location.hash.startsWith("#s-")) location.replace(location.hash);  // the pictures have moved the scenario
}

function showGallery(page) {
  const runs = new Map(report.scenarios.map((scenario, i) => [scenario.page === page ? i : -1, []]));
  for (const run of report.runs) if (runs.has(run[0])) runs.get(run[0]).push(run);
  const figures = report.scenarios.map((scenario, i) => (scenario.page === page ? figureOf(scenario, runs.get(i)) : null));
  element("gallery").replaceChildren(html("div", { class: "gallery", "data-page": page }, figures));
  document.querySelectorAll("#pages button").forEach((button, i) => button.setAttribute("aria-current", String(i + 1 === page)));
  if (report.scenarios.length > 0) loadScript(`data/pictures-${page}.js`);
}

const pageOf = (hash) => (report.scenarios.find((scenario) => scenario.hash === hash) || { page: 1 }).page;

// Opens the gallery at the page of a scenario.
function showScenario(hash) {
  unfoldAround(element("scenarios"));
  if (!element("s-" + hash)) showGallery(pageOf(hash));
}

function gallerySection() {
  const button = (page) => {
    const node = html("button", {}, String(page));
    node.addEventListener("click", () => showGallery(page));
    return node;
  };
  const pages = report.scenarios.length > 0 ? report.scenarios[report.scenarios.length - 1].page : 1;
  setTimeout(() => element("gallery").firstChild || showGallery(1));
  return [galleryLegend(), pages === 1 ? null : html("p", { class: "controls", id: "pages" }, "Page",
            Array.from({ length: pages }, (_, i) => button(i + 1))), html("div", { id: "gallery" })];
}
