// SPDX-License-Identifier: BSD-3-Clause
// The page on which the reader chooses: any metric, by any descriptor or metric, of the runs that a filter leaves. The
// address has the choices.
"use strict";

const choice = { metric: "", by: "", filter: "" };

function runText(run) {
  const text = (id) => {
    const value = field(id)[run];
    return `${id} ${typeof value === "number" ? value : "NA (" + value + ")"}`;
  };
  return `${field("scenario")[run]}, ${field("method")[run]} #${field("repetition")[run]}: ${field("outcome")[run]}, ${text(choice.metric)}, ${text(choice.by)}`;
}

// The address of the list of the runs for which the words hold besides the filter.
const listAddress = (...words) => "runs.html" + addressOf("", { filter: [choice.filter, ...words].filter(Boolean).join(" "),
                                                                sort: choice.metric, columns: choice.metric + "," + choice.by });
function wordsOf(bin) {
  const words = bin.low === null ? [] : [`${choice.by}>=${bin.low}`];
  return bin.high === null ? words : [...words, `${choice.by}${bin.high_included ? "<=" : "<"}${bin.high}`];
}

function describedCell(group, href, digits, rate) {
  const { n, mean, quantiles, na } = group, missing = reasonsText(na);
  if (n + Object.keys(na).length === 0) return html("td", { class: "na" }, "–");
  return html("td", { class: n > 0 ? "cell" : "cell na" },
    html("a", { class: "big", href }, n > 0 ? numberText(mean, digits) : "–"),
    n > 0 ? html("span", { class: "interval" }, rate ? intervalText(group.interval, digits)
      : [1, 2, 3].map((i) => numberText(quantiles[i], digits)).join(" · ")) : null,
    support(rate && n > 0 ? countText(group) : "n=" + n, missing ? html("span", { class: "wrap" }, " NA: " + missing) : null));
}

// The bins with the words that select their runs, and per method the group of their values.
function groupedRows(runs, quantity, methods) {
  const values = field(choice.metric), positions = field(choice.by), bins = report.bins[choice.by] || [];
  const rows = bins.map((bin) => ({ title: bin.bin, words: wordsOf(bin), isBin: true, runs: runs.filter((run) => inBin(bin)(positions[run])) }));
  const outside = runs.filter((run) => typeof positions[run] !== "number");
  if (outside.length > 0) rows.push({ title: "NA", words: [choice.by + "=NA"], runs: outside });
  rows.push({ title: "all", words: [], runs });
  const groupOf = (row, method) => {
    const group = describe(row.runs.filter((run) => report.runs[run][1] === method), values);
    return { ...group, interval: isRate(quantity) ? rateInterval(group) : null };
  };
  return rows.map((row) => ({ ...row, groups: methods.map((method) => groupOf(row, method)) }));
}

// Means and quartiles by bin and method; every number links to its runs.
function choiceTable(rows, quantity, across, methods) {
  const digits = digitsOf(rows.flatMap(({ groups }) => groups), { rate: isRate(quantity) });
  const line = ({ title, words, groups }) => html("tr", {}, html("th", {}, title),
    methods.map((method, at) => describedCell(groups[at], listAddress(methodWord(method), ...words), digits, isRate(quantity))));
  return card(html("h2", { class: "title" }, "Values"),
    tableOf({ class: "even", style: `min-width:${9 + 9 * methods.length}rem` },
            [heading(axisLabel(across)), methods.map((method) => html("th", {}, methodName(method)))], rows.map(line)),
    html("p", { class: "support" }, "Each cell: " + (isRate(quantity) ? "the fraction of the values that are 1 with its interval, where each scenario " +
         "has one run, how many of how many, and why others are missing. " : "the mean; the three quartiles; the number n of values, and why the others are " +
         "missing. ") + "Rows: bins with about equal numbers of scenarios." + (report.selected ? "" : " The same by a command:")),
    report.selected ? null
      : commandLine(`slalom-analyze table ${shellWord(report.results)} --rows "${choice.by}:q4" --columns ${choice.metric}`));
}

// The pictures of the scenarios of the selected runs, at most as many as are seen at once.
function showSelection(runs) {
  const most = 24, scenarios = [...new Set(runs.map((run) => report.runs[run][0]))], shown = scenarios.slice(0, most);
  const runsOf = (scenario) => runs.map((run) => report.runs[run]).filter((run) => run[0] === scenario);
  element("selection").replaceChildren(
    html("h2", { class: "title" }, `${plural(runs.length, "selected run")} in ${plural(scenarios.length, "scenario")}` +
                   (shown.length < scenarios.length ? `, the first ${most}:` : "")),
    html("div", { class: "gallery" }, shown.map((scenario) => figureOf(report.scenarios[scenario], runsOf(scenario)))));
  for (const page of new Set(shown.map((scenario) => report.scenarios[scenario].page))) loadScript(`data/pictures-${page}.js`);
}

const chartCard = (title, ...content) => html("div", { class: "card chart-card" }, html("h2", { class: "title" }, title), ...content.flat());

function distributionCards(quantity, values, groups) {
  const box = boxChart(quantity, values, groups);
  return [chartCard("Distribution by method", markChart(box.picture, box.points, runText, showSelection),
                    support("Box: quartiles; line: 5 % to 95 % of the values; below, every run.")),
          chartCard("Cumulative distribution", cumulativeChart(quantity, groups))];
}

function showChoice() {
  let runs = [], problem = "";
  try { runs = filterRuns(report.runs.map((_, index) => index), choice.filter); } catch (text) { problem = String(text); }
  const quantity = quantityOf(choice.metric), across = quantityOf(choice.by), values = field(choice.metric);
  const methods = report.methods.map((_, i) => i).filter((method) => runs.some((run) => report.runs[run][1] === method));
  const groups = methods.map((method) => ({ method, ...describe(runs.filter((run) => report.runs[run][1] === method), values) }));
  const rows = groupedRows(runs, quantity, methods), bins = rows.filter(({ isBin }) => isBin);
  const scatter = scatterChart(quantity, values, across, field(choice.by), runs);
  element("count").textContent = problem || plural(runs.length, "run");
  element("report").replaceChildren(html("div", { class: "charts" },
      chartCard(`${axisLabel(quantity)} by ${axisLabel(across)}`, binChart(quantity, across, bins.map(({ title }) => title), bins.map((row) => row.groups), methods)),
      chartCard("Runs over " + across.name, markChart(scatter.picture, scatter.points, runText, showSelection), legend(groups.map(({ method }) =>
        ({ color: report.methods[method].color, label: methodLabel(method) }))), html("div", { class: "legend" }, report.outcomes.map(markItem)), support("In the strip NA: runs without a value.")),
      isRate(quantity) ? "" : distributionCards(quantity, values, groups)),
    html("section", { id: "selection", "aria-live": "polite" }), choiceTable(rows, quantity, across, methods));
  writeAddress("", choice);
  document.title = `${quantity.name} by ${across.name} - ${report.campaign}`;
  document.body.dataset.ready = String(runs.length);
}

const options = (list) => list.map(({ id, name }) => html("option", { value: id }, `${name} (${id})`));

function readChoice() {
  const { settings } = readAddress(), known = (id) => (id && quantityOf(id) ? id : null);
  const rows = report.tables.map((table) => table.descriptor.id).filter(known);
  choice.metric = known(settings.metric) || report.columns[0].id;
  choice.by = known(settings.by) || rows[0] || (report.descriptors[0] || report.columns[0]).id;
  choice.filter = settings.filter || "";
  for (const key of Object.keys(choice)) element(key).value = choice[key];
  showChoice();
}

function startPage() {
  const metrics = [...allQuantities().values()].filter(({ id }) => !report.descriptors.some((one) => one.id === id));
  element("metric").append(...options(metrics));
  element("by").append(html("optgroup", { label: "Descriptors" }, options(report.descriptors)),
                       html("optgroup", { label: "Metrics" }, options(metrics)));
  for (const key of Object.keys(choice))
    element(key).addEventListener("input", (event) => { choice[key] = event.target.value; showChoice(); });
  window.addEventListener("hashchange", readChoice);
  readChoice();
}

if (report.columns && report.runs && report.values) startPage();
else element("problem").hidden = false;
