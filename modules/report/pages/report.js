// Draws index.html (the whole campaign), method.html#INDEX (one method, from 1) and, with clusters.js, cluster.html from
// the data of report.json.
"use strict";

// ---- cells of tables ---------------------------------------------------------------------------

// Cells with fewer values get neither shade nor whisker: they would dominate the column's scale.
const enoughToDraw = (cell) => cell.n >= 5 && cell.interval !== null;

// Three significant digits of the largest number.
function digitsOf(cells, column) {
  const largest = Math.max(0, ...cells.map((cell) => Math.abs(cell.mean || 0)));
  return column.rate || largest === 0 ? 2 : Math.min(4, Math.max(0, 2 - Math.floor(Math.log10(largest))));
}

// The common scale of the cells of a column: `low` and `high` of whiskers, `worst` and `best` of shades.
function scaleOf(column, cells) {
  const scale = { column, digits: digitsOf(cells, column), low: 0, high: 1, worst: 0, best: 1 };
  const drawn = cells.filter(enoughToDraw), means = drawn.map((cell) => cell.mean);
  if (column.rate || drawn.length === 0) return scale;
  scale.low = Math.min(...drawn.map((cell) => cell.interval[0]));
  scale.high = Math.max(...drawn.map((cell) => cell.interval[1]));
  const ends = [Math.min(...means), Math.max(...means)];
  [scale.worst, scale.best] = column.direction === "down" ? ends.reverse() : ends;
  return scale;
}

const goodness = (mean, { worst, best }) => (best === worst ? 0.5 : (mean - worst) / (best - worst));
const numberText = (number, digits) => (Math.abs(number) < 1e9 ? fixed(number, digits) : String(number));
const intervalText = (interval, digits) =>
  interval ? `[${numberText(interval[0], digits)}, ${numberText(interval[1], digits)}]` : "";
const missing = (cell) => Object.values(cell.na).reduce((sum, n) => sum + n, 0);
const valuesText = (cell) => "n=" + cell.n + (missing(cell) ? " NA=" + missing(cell) : "");
const reasonsText = (na) => Object.entries(na).map(([reason, n]) => n + " " + reason).join(", ");
const support = (...children) => html("span", { class: "support" }, ...children);

function supportText(cell, column, digits) {
  if (column.rate && cell.mean !== null)
    return Math.round(cell.mean * cell.n) + "/" + cell.n + (missing(cell) ? " NA=" + missing(cell) : "");
  return (cell.deviation === null ? "" : "±" + numberText(cell.deviation, digits) + " ") + valuesText(cell);
}

// The mean as a dot on its interval.
function whisker(cell, { low, high }) {
  if (!enoughToDraw(cell) || high <= low) return null;
  const x = (value) => (4 + (112 * (value - low)) / (high - low)).toFixed(1);
  const bar = (name, from, to) => svg("line", { class: name, x1: from, x2: to, y1: 4.5, y2: 4.5 });
  return svg("svg", { class: "whisker", viewBox: "0 0 120 9", preserveAspectRatio: "xMinYMid", "aria-hidden": "true" },
    bar("axis", 4, 116), bar(null, x(cell.interval[0]), x(cell.interval[1])),
    svg("circle", { cx: x(cell.mean), cy: 4.5, r: 3 }));
}

const runsLink = (group) => "runs.html#cell-" + group;

// `shade` from 0 to 1, null for none.
function cellNode(cell, group, digits, shade, below) {
  const title = missing(cell) ? "missing: " + reasonsText(cell.na) : null;
  return html("td", { class: cell.mean === null ? "cell na" : "cell", title,
                      style: shade === null ? null : "--g:" + shade.toFixed(2) },
    html("a", { class: "big", href: runsLink(group) }, cell.mean === null ? "–" : numberText(cell.mean, digits)),
    html("span", { class: "interval" }, intervalText(cell.interval, digits)), below);
}

function tableCell(cell, scale, group) {
  const shaded = scale.column.direction !== "none" && cell.mean !== null && enoughToDraw(cell);
  return cellNode(cell, group, scale.digits, shaded ? goodness(cell.mean, scale) : null,
                  [whisker(cell, scale), support(supportText(cell, scale.column, scale.digits))]);
}

function headerCell(column) {
  const arrow = { up: " ↑", down: " ↓", none: "" }[column.direction], unit = column.unit === "-" ? "" : ` [${column.unit}]`;
  return html("th", {}, column.name + arrow + unit, html("br"), html("code", {}, column.id),
              column.wall_clock ? [html("br"), "wall clock"] : null);
}

const tableOf = (attributes, header, rows) =>
  html("table", attributes, html("thead", {}, html("tr", {}, header)), html("tbody", {}, rows));
const card = (...children) => html("div", { class: "card" }, ...children);
const soft = (...children) => html("p", { class: "soft" }, ...children);
const heading = (text) => html("th", {}, text);
const methodName = (index) => [swatch(report.methods[index].color), report.methods[index].name];
const finding = (text, shown) => html("p", { class: shown ? "finding shown" : "finding soft" }, text);

// ---- sections; `method` restricts them to one, null: all ---------------------------------------

function outcomeCell(method) {
  const parts = report.outcomes.map((outcome, i) => [outcome, method.outcomes[i]]).filter(([, n]) => n > 0);
  const bar = ([outcome, n]) => html("i", { class: outcomeClass(outcome), style: "flex:" + n, title: outcome + " " + n });
  return html("td", {}, html("div", { class: "bar" }, parts.map(bar)), parts.map(([outcome, n]) => outcomeChip(outcome, n)));
}

function summarySection(method) {
  const rows = report.summary.filter((row) => method === null || row.method === method);
  const scales = report.columns.map((column, i) => scaleOf(column, rows.map((row) => row.cells[i])));
  const line = (row) => html("tr", {},
    html("th", { class: "name" }, swatch(report.methods[row.method].color),
         html("a", { href: "method.html#" + (row.method + 1) }, report.methods[row.method].name)),
    html("td", {}, String(row.n)), outcomeCell(row), scales.map((scale, i) => tableCell(row.cells[i], scale, row.runs)));
  const percent = Number((100 * report.confidence).toPrecision(12));
  return [card(tableOf({}, [["Method", "Runs", "Outcomes"].map(heading), report.columns.map(headerCell)], rows.map(line))),
          method !== null ? null : soft(`Each cell: the mean (for success the fraction of runs) with its ${percent} % ` +
            "confidence interval, drawn below on the column's scale; then the standard deviation and the number n of values. " +
            "NA: the number of runs without a value, which are excluded from the mean. ↑ higher is better, ↓ lower is better; " +
            "a stronger shade is better within its column; cells with fewer than 5 values are not shaded.")];
}

function findingsSection() {
  const groups = report.tables.filter((group) => group.methods.some((table) => table.rows.length > 1));
  return [soft("The lowest and the highest bin with at least 10 values are compared. A difference is reported only if their " +
               "intervals do not overlap; overlapping intervals do not prove that there is no difference."),
          groups.length === 0 ? html("p", {}, "No bins to compare.") : null,
          groups.map((group) => [html("h3", {}, "By " + group.descriptor.name),
            card(group.methods.map((table) => table.findings.map((one) => finding(one.text, one.difference))))])];
}

// Links to some of the runs and to the list of all of them.
function runsList(group) {
  const runs = report.groups[group].runs, shown = runs.slice(0, 20);
  const item = (index) => {
    const [scenario, method, repetition, outcome] = report.runs[index], { hash, name } = report.scenarios[scenario];
    return html("li", {}, html("a", { href: "run.html#" + runId(hash, report.methods[method].name, repetition) },
                               name + " #" + repetition), " ", outcomeChip(report.outcomes[outcome]));
  };
  const all = html("li", {}, html("a", { href: runsLink(group) }, "all " + plural(runs.length, "run")));
  return html("details", { class: "runs" }, html("summary", {}, plural(runs.length, "run")),
              html("ul", { class: "plain" }, shown.map(item), shown.length < runs.length ? all : null));
}

// The reasons of missing values of a column over all rows.
function missingOf(table, column) {
  const sums = {};
  for (const row of table.rows)
    for (const [reason, n] of Object.entries(row.cells[column].na)) sums[reason] = (sums[reason] || 0) + n;
  const text = reasonsText(sums);
  return text && report.columns[column].id + ": " + text;
}

function crossTable(table, descriptor, scales) {
  const unit = descriptor.unit === "-" ? "" : ` [${descriptor.unit}]`, width = `min-width:${9 + 8 * scales.length}rem`;
  const line = (row) => html("tr", {}, html("th", {}, row.bin, runsList(row.runs)),
                             scales.map((scale, i) => tableCell(row.cells[i], scale, row.runs)));
  const notAvailable = scales.map((_, i) => missingOf(table, i)).filter(Boolean).join(" · ");
  return card(html("h4", {}, methodName(table.method)),
    tableOf({ class: "even", style: width }, [heading(descriptor.name + unit), report.columns.map(headerCell)], table.rows.map(line)),
    notAvailable ? html("p", { class: "support" }, "Not available: " + notAvailable) : null,
    table.notes.map((note) => html("p", { class: "support" }, note)));
}

function tablesSection(method) {
  return report.tables.filter((group) => group.methods.length > 0).map((group) => {
    const tables = group.methods.filter((table) => method === null || table.method === method);
    const scales = report.columns.map((column, i) =>
      scaleOf(column, tables.flatMap((table) => table.rows.map((row) => row.cells[i]))));
    return [method === null ? html("h3", {}, "By " + group.descriptor.name + " ", html("code", {}, group.descriptor.id)) : null,
            tables.map((table) => crossTable(table, group.descriptor, scales))];
  });
}

// Significant differences; the other comparisons are in a collapsed section below.
function comparisonSection(method) {
  const all = report.comparisons.filter((one) => method === null || one.a === method || one.b === method);
  if (all.length === 0) return null;
  const others = all.filter((one) => !one.significant), sentence = (one) => finding(one.text, one.significant);
  return [soft("On the same scenarios; p values corrected for the number of comparisons (Holm)."),
    card(all.filter((one) => one.significant).map(sentence),
         others.length === 0 ? null : html("details", {}, html("summary", {},
           plural(others.length, "comparison") + " without a difference shown"), others.map(sentence)))];
}

const seriesOf = (curves) =>
  curves.map(({ method, points }) => ({ label: report.methods[method].name, color: report.methods[method].color, points, steps: true }));

function completionSection() {
  const last = Math.max(0, ...report.completion.flatMap((curve) => curve.points.slice(-1).map(([time]) => time)));
  if (last === 0) return null;
  const series = seriesOf(report.completion.map(({ method, points }) => ({ method, points: [[0, 0], ...points] })));
  return card(html("h4", {}, "Fraction of runs that have reached the goal"),
    chart({ label: "simulated time (s)", low: 0, high: last }, fractionAxis("fraction of runs"), series), legend(series),
    html("p", { class: "support" }, "Aalen-Johansen estimate: the other outcomes are competing risks, so that each curve " +
         "ends at the success rate."));
}

function profileCard(profile) {
  const series = seriesOf(profile.curves.map(({ method, points }) =>
    ({ method, points: points.filter(([ratio]) => ratio <= 16) })));
  return card(html("h4", {}, "Performance profile of " + profile.metric),
    chart({ label: "ratio to the best method in the scenario", low: 1, high: 16, logarithmic: true },
          fractionAxis("fraction of scenarios"), series), legend(series),
    html("p", { class: "support" }, `Fraction of the ${profile.scenarios} scenarios in which a method is within a ratio of ` +
         "the best one (Dolan and Moré 2002); the value at 1 is the fraction in which it is the best." +
         (profile.left_out ? ` Left out: ${plural(profile.left_out, "scenario")} in which no method has a value.` : "")));
}

function rankCard(ranks) {
  const methods = ranks.methods.map(({ method, rank }) =>
    ({ label: report.methods[method].name, color: report.methods[method].color, rank }));
  const p = ranks.p < 0.001 ? "p < 0.001" : "p = " + fixed(ranks.p, 3);
  return card(html("h4", {}, "Mean ranks in " + ranks.metric), rankDiagram(methods, ranks.groups, ranks.critical_difference),
    html("p", { class: "support" }, `Friedman test over ${ranks.scenarios} of ${plural(ranks.all_scenarios, "scenario")}: ${p}; ` +
         `bars join methods whose mean ranks do not differ by the critical difference (Nemenyi, level ${ranks.level}).` +
         (ranks.left_out ? ` Left out: ${ranks.left_out}.` : "")));
}

function rankingSection() {
  const of = (list, column, draw) => list.filter((one) => one.metric === column.id).map(draw);
  const cards = report.columns.map((column) => [of(report.ranks, column, rankCard), of(report.profiles, column, profileCard)]);
  return cards.flat(2).length > 0 ? cards : null;
}

function mapCard(map) {
  const column = report.columns.find((one) => one.id === map.metric);
  const field = (cell) => {
    if (cell.n + missing(cell) === 0) return html("td", { class: "cell na" }, "–");
    return cellNode(cell, cell.runs, 2, column.rate && enoughToDraw(cell) ? cell.mean : null, support(valuesText(cell)));
  };
  const rows = map.rows.map((bin, i) => html("tr", {}, html("th", {}, bin), map.fields[i].map(field)));
  return card(html("h4", {}, methodName(map.method), ": " + map.metric),
    tableOf({ class: "even" }, [heading(map.row_descriptor + " \\ " + map.column_descriptor), map.columns.map(heading)],
            rows.reverse()),  // upwards, as in a plot
    map.left_out ? html("p", { class: "support" }, plural(map.left_out, "run") + " outside all bins or without a value") : null);
}

function mapSection(method) {
  const maps = report.maps.filter((map) => method === null || map.method === method);
  return maps.length === 0 ? null : maps.map(mapCard);
}

function repeatSection() {
  const entries = Object.entries(report.manifest), isShort = ([, text]) => !text.includes("\n");
  return [html("p", {}, "Save ", html("code", {}, "campaign.ini"), " below and run ",
               html("code", {}, "slalom-evaluate campaign.ini -o out"), ", or ",
               html("code", {}, "slalom-simulate run -c campaign.ini"), " with the original scenario list, using the versions " +
               "listed: the results are identical except for wall-clock timings."),
    card(html("table", {}, html("tbody", {}, entries.filter(isShort).map(([key, text]) =>
           html("tr", {}, heading(key), html("td", {}, html("code", {}, text)))))),
         entries.filter((entry) => !isShort(entry)).map(([key, text]) =>
           html("details", { open: "" }, html("summary", {}, key), html("pre", {}, text))))];
}

function outcomesSection(method) {
  const rows = report.outcome_fractions.filter((row) => row.method === method).map((row) => html("tr", {},
    html("th", {}, outcomeChip(row.outcome)),
    html("td", {}, fixed(row.fraction, 2) + " " + intervalText(row.interval, 2)),
    html("td", {}, html("a", { href: runsLink(row.runs) }, plural(row.n, "run")))));
  return card(html("table", {}, html("tbody", {}, rows)));
}

function validitySection(method) {
  const all = report.validity.filter((one) => one.method === method);
  if (all.length === 0) return null;
  const metrics = [...new Set(all.map((one) => one.metric))], descriptors = [...new Set(all.map((one) => one.descriptor))];
  const field = (descriptor, metric) => {
    const { rho, interval } = all.find((one) => one.descriptor === descriptor && one.metric === metric);
    if (rho === null) return html("td", { class: "na" }, "–");
    return html("td", {}, fixed(rho, 2), html("span", { class: "interval" }, intervalText(interval, 2)));
  };
  const line = (descriptor) => html("tr", {}, heading(descriptor), metrics.map((metric) => field(descriptor, metric)));
  return [soft("Spearman's rank correlation of each scenario descriptor with the performance of the method, with intervals."),
          card(tableOf({}, ["Descriptor", ...metrics].map(heading), descriptors.map(line)))];
}

// ---- the gallery of scenarios ------------------------------------------------------------------

function galleryLegend() {
  const sample = (attributes) => svg("svg", { width: 34, height: 10, "aria-hidden": "true" },
    svg("line", { x1: 1, y1: 5, x2: 33, y2: 5, stroke: "currentColor", "stroke-width": 1.5, ...attributes }));
  const item = (...children) => html("span", {}, ...children);
  return html("div", { class: "legend" },
    report.methods.map(({ name, color }) => item(sample({ stroke: color, "stroke-width": 3 }), name)),
    item(sample({ "stroke-dasharray": "7 3" }), "shortest path"), item(sample({ "stroke-dasharray": "2 3" }), "safest path"),
    ["● goal reached", "✕ failure", "○ with a dash: start", "⊕ goal"].map((text) => item(text)));
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
              report.methods[run[1]].name + (run[2] > 0 ? " #" + run[2] : ""))),
    html("td", {}, outcomeChip(report.outcomes[run[3]], 0, run[4])), columns.map(([, index]) => value(run, index)));
  return tableOf({}, ["", "", ...columns.map(([column]) => column.id)].map(heading), runs.map(line));
}

function figureOf(scenario, runs) {
  const value = (number, { id, unit }) => [html("dt", {}, id), typeof number === "number"
    ? html("dd", {}, fixed(number, 3) + (unit === "-" ? "" : " " + unit)) : html("dd", { class: "na" }, "NA: " + number)];
  return html("figure", { id: "s-" + scenario.hash }, html("h4", {}, scenario.name), html("div", { class: "picture" }),
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

// The page of the scenario in the address.
const requestedPage = () =>
  (report.scenarios.find((scenario) => "#s-" + scenario.hash === location.hash) || { page: 1 }).page;

function gallerySection() {
  const button = (page) => {
    const node = html("button", {}, String(page));
    node.addEventListener("click", () => showGallery(page));
    return node;
  };
  const pages = report.scenarios.length > 0 ? report.scenarios[report.scenarios.length - 1].page : 1;
  return [galleryLegend(), pages === 1 ? null : html("p", { class: "controls", id: "pages" }, "Page",
            Array.from({ length: pages }, (_, i) => button(i + 1))), html("div", { id: "gallery" })];
}

// ---- pages -------------------------------------------------------------------------------------

// Draws sections, [id, title, content]; those without content are left out.
function showSections(sections) {
  const shown = sections.filter(([, , content]) => content !== null);
  element("report").replaceChildren(...shown.flatMap(([id, title, content]) =>
    [html("h2", { id }, title), ...[content].flat(Infinity).filter((node) => node !== null)]));
  return shown;
}

function showCampaign() {
  const shown = showSections([
    ["clusters", "Failures", clustersSection()], ["summary", "Summary", summarySection(null)], ["findings", "Findings", findingsSection()],
    ["tables", "Cross tables", tablesSection(null)], ["comparisons", "Pairwise comparisons", comparisonSection(null)],
    ["completion", "Completion", completionSection()], ["ranks", "Ranks and profiles", rankingSection()],
    ["maps", "Maps", mapSection(null)], ["scenarios", "Scenarios", gallerySection()],
    ["repeat", "Reproducibility", repeatSection()]]);
  element("navigation").replaceChildren(html("div", {}, shown.map(([id, title]) => html("a", { href: "#" + id }, title)),
                                             html("a", { href: "runs.html" }, "All runs")));
  showGallery(requestedPage());
  window.addEventListener("hashchange", () => {
    if (location.hash.startsWith("#s-") && !document.getElementById(location.hash.slice(1))) showGallery(requestedPage());
  });
}

function showMethod() {
  const index = Math.min(report.methods.length, Math.max(1, Number(location.hash.slice(1)) || 1)) - 1;
  const { name } = report.methods[index];
  document.title = report.campaign + ": " + name;
  element("title").textContent = name;
  element("campaign").textContent = "Report of " + report.campaign;
  showSections([
    ["summary", "Summary", summarySection(index)], ["outcomes", "Outcomes", outcomesSection(index)],
    ["comparisons", "Comparisons with the other methods", comparisonSection(index)],
    ["tables", "Results by descriptor", tablesSection(index)], ["maps", "Maps", mapSection(index)],
    ["validity", "Difficulty factors", validitySection(index)]]);
}

if (!report.summary || !report.runs) {
  element("problem").hidden = false;
} else if (element("navigation")) {
  showCampaign();
} else if (element("report").dataset.page === "cluster") {
  showCluster();
  window.addEventListener("hashchange", showCluster);
} else {
  showMethod();
  window.addEventListener("hashchange", showMethod);
}
