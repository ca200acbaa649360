// SPDX-License-Identifier: BSD-3-Clause
// Sections of index.html and method.html that are tables and sentences; `method` restricts them to one, null: all.
"use strict";

function outcomeBar(method) {
  const parts = report.outcomes.map((outcome, i) => [outcome, method.outcomes[i]]).filter(([, n]) => n > 0);
  const bar = ([outcome, n]) => html("i", { class: outcomeKind(outcome), style: "flex:" + n, title: outcome + " " + n });
  return [html("div", { class: "bar" }, parts.map(bar)), parts.map(([outcome, n]) =>
    outcomeChip(outcome, n, null, listOf(methodWord(method.method), "outcome=" + outcome)))];
}

// The reasons of missing values of the columns over all rows.
function missingNote(rows) {
  const texts = report.columns.map((column, i) => {
    const sums = {};
    for (const row of rows) for (const [reason, n] of Object.entries(row.cells[i].na)) sums[reason] = (sums[reason] || 0) + n;
    const text = reasonsText(sums);
    return text && column.id + ": " + text;
  }).filter(Boolean);
  return texts.length > 0 ? html("p", { class: "support" }, "Not available: " + texts.join(" · ")) : null;
}

function summarySection(method) {
  const rows = report.summary.filter((row) => method === null || row.method === method);
  const columns = report.selected ? [] : report.columns;
  const scales = columns.map((column, i) => scaleOf(column, rows.map((row) => row.cells[i])));
  const line = (row) => html("tr", {},
    html("th", { class: "name" }, swatch(report.methods[row.method].color),
         html("a", { href: "method.html#" + (row.method + 1) }, methodLabel(row.method))),
    html("td", {}, html("a", { href: runsLink(row.runs) }, String(row.n))), html("td", {}, outcomeBar(row)),
    scales.map((scale, i) => tableCell(row.cells[i], scale, row.runs)));
  const percent = Number((100 * report.confidence).toPrecision(12));
  const table = tableOf({}, [["Method", "Runs", "Outcomes"].map(heading), columns.map((column) => headerCell(column, ""))], rows.map(line));
  if (report.selected)
    return [card(table), soft("A search has selected these scenarios. They are a sample of no environment, so that outcomes are only counted.")];
  return [card(table, missingNote(rows)),
          method !== null ? null : commonSection(),
          method !== null ? null : soft(`Each cell: the mean (for success the fraction of runs) with its ${percent} % ` +
            "confidence interval, drawn below on the column's scale; then the standard deviation and the number n of values. " +
            "NA: the number of runs without a value, which are excluded from the mean. ↑ higher is better, ↓ lower is better; " +
            "a stronger shade is better within its column; cells with fewer than 5 values, and those in " +
            "which more than 10 % of the runs have no value, are not shaded.")];
}

function findingsSection() {
  if (report.selected) return null;
  const groups = report.tables.filter((group) => group.methods.some((table) => table.rows.length > 1));
  return [soft("Each metric is tested for a trend over all bins; p values corrected for the number of tests (Holm). No trend " +
               "shown does not prove that there is none."),
          groups.length === 0 ? html("p", {}, "No bins to compare.") : null,
          groups.map((group) => [html("h3", {}, "By " + group.descriptor.name),
            findingsCard(group.methods.flatMap((table) => table.findings))])];
}

// Differences; what shows none is folded below.
function findingsCard(findings) {
  const others = findings.filter((one) => !one.difference), sentence = (one) => finding(one.text, one.difference);
  return card(findings.filter((one) => one.difference).map(sentence), others.length === 0 ? null
    : html("details", {}, html("summary", {}, plural(others.length, "finding") + " without a trend shown"), others.map(sentence)));
}

function crossTable(table, descriptor, scales) {
  const width = `min-width:${9 + 8 * scales.length}rem`;
  const runsOf = ({ runs }) => html("a", { class: "support", href: runsLink(runs) }, plural(report.groups[runs].runs.length, "run"));
  const line = (row) => html("tr", {}, html("th", {}, row.bin, runsOf(row)),
                             scales.map((scale, i) => tableCell(row.cells[i], scale, row.runs)));
  return card(html("h3", { class: "title" }, methodName(table.method)),
    tableOf({ class: "even", style: width }, [heading(descriptor.name + unitText(descriptor)), report.columns.map((column) => headerCell(column, descriptor.id))], table.rows.map(line)),
    missingNote(table.rows), table.notes.map((note) => html("p", { class: "support" }, note)));
}

// Each descriptor folds; the first one is open.
function tablesSection(method) {
  if (report.selected) return null;
  return report.tables.filter((group) => group.methods.length > 0).map((group, i) => {
    const tables = group.methods.filter((table) => method === null || table.method === method);
    const scales = report.columns.map((column, at) =>
      scaleOf(column, tables.flatMap((table) => table.rows.map((row) => row.cells[at]))));
    const draw = () => tables.map((table) => crossTable(table, group.descriptor, scales));
    return fold("by-" + group.descriptor.id + "-" + (i + 1), ["By " + group.descriptor.name + " ", html("code", {}, group.descriptor.id)],
                draw, i === 0, 3);
  });
}

// Significant differences; the other comparisons are in a collapsed section below.
function comparisonSection(method) {
  const all = report.comparisons.filter((one) => method === null || one.a === method || one.b === method);
  if (all.length === 0) return null;
  const others = all.filter((one) => !one.significant), sentence = (one) => finding(one.text, one.significant);
  return [soft("On the same scenarios; p values corrected (Holm) for all pairs of methods in the same metric."),
    card(all.filter((one) => one.significant).map(sentence),
         others.length === 0 ? null : html("details", {}, html("summary", {},
           plural(others.length, "comparison") + " without a difference shown"), others.map(sentence)))];
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
  if (rows.length === 0) return null;
  return card(html("table", {}, html("tbody", {}, rows)));
}

function validitySection(method) {
  const all = report.validity.filter((one) => one.method === method);
  if (all.length === 0) return null;
  const metrics = [...new Set(all.map((one) => one.metric))], descriptors = [...new Set(all.map((one) => one.descriptor))];
  const field = (descriptor, metric) => {
    const { rho, interval } = all.find((one) => one.descriptor === descriptor && one.metric === metric);
    if (rho === null) return html("td", { class: "na" }, "–");
    const explore = "explore.html" + addressOf("", { metric, by: descriptor, filter: methodWord(method) });
    return html("td", {}, html("a", { href: explore }, fixed(rho, 2)), html("span", { class: "interval" }, intervalText(interval, 2)));
  };
  const line = (descriptor) => html("tr", {}, heading(descriptor), metrics.map((metric) => field(descriptor, metric)));
  return [soft("Spearman's rank correlation of each scenario descriptor with the performance of the method, with intervals."),
          card(tableOf({}, ["Descriptor", ...metrics].map(heading), descriptors.map(line)))];
}
