// The page of many runs: those of one number of a table (runs.html#cell-12) or all (runs.html), as a sortable and
// filterable table.
"use strict";

const LIMIT = 500;  // maximum number of displayed rows
const view = { runs: [], column: 0, descending: false };

// The value of a run in column `column`: texts first, then numbers; null if not available.
function fieldOf(run, column) {
  const [scenario, method, repetition, outcome, , ...values] = run;
  if (column === 0) return report.scenarios[scenario].name;
  if (column === 1) return report.methods[method].name;
  if (column === 2) return repetition;
  if (column === 3) return report.outcomes[outcome];
  return typeof values[column - 4] === "number" ? values[column - 4] : null;
}

function compare(a, b) {
  if (a === null || b === null) return (a === null) - (b === null);
  return typeof a === "number" ? a - b : a.localeCompare(b, "en", { numeric: true });
}

function shown() {
  const words = element("filter").value.toLowerCase().split(/\s+/).filter(Boolean);
  const text = (run) => [0, 1, 2, 3].map((column) => fieldOf(run, column)).join(" ").toLowerCase();
  const runs = view.runs.filter((run) => words.every((word) => text(run).includes(word)));
  const sign = view.descending ? -1 : 1;
  return runs.sort((a, b) => sign * compare(fieldOf(a, view.column), fieldOf(b, view.column)));
}

function rowOf(run) {
  const id = runId(report.scenarios[run[0]].hash, report.methods[run[1]].name, run[2]);
  const field = (column) => {
    const value = fieldOf(run, column);
    return value === null ? html("td", { class: "na", title: run[column + 1] }, "NA") : html("td", {}, String(value));
  };
  const columns = Array.from({ length: 3 + report.columns.length }, (_, i) => i + 1);
  return html("tr", {}, html("th", {}, html("a", { href: "run.html#" + id }, fieldOf(run, 0))), columns.map(field));
}

function show() {
  const runs = shown();
  element("rows").replaceChildren(...runs.slice(0, LIMIT).map(rowOf));
  element("count").textContent =
    runs.length + " runs" + (runs.length > LIMIT ? ", showing the first " + LIMIT : "");
  document.body.dataset.ready = String(runs.length);
}

function headerOf(name, column) {
  const button = html("button", {}, name);
  button.addEventListener("click", () => {
    view.descending = view.column === column && !view.descending;
    view.column = column;
    show();
  });
  return html("th", {}, button);
}

function selectRuns() {
  const found = /^#cell-(\d+)$/.exec(location.hash), cell = found ? report.groups[Number(found[1])] : null;
  if (found && !cell) {
    element("title").textContent = "This report does not contain this cell";
    view.runs = [];
  } else {
    element("title").textContent = cell ? cell.title : "All runs";
    view.runs = cell ? cell.runs.map((index) => report.runs[index]) : report.runs.slice();
  }
  show();
}

if (!report.columns || !report.runs) {
  element("title").textContent = "The data folder of this report is missing";
} else {
  const names = ["scenario", "method", "repetition", "outcome", ...report.columns.map((column) => column.id)];
  element("header").replaceChildren(...names.map(headerOf));
  element("filter").addEventListener("input", show);
  window.addEventListener("hashchange", selectRuns);
  selectRuns();
}
