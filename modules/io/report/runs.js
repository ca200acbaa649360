// The page of many runs: those of one cell of a table (runs.html#cell-12), or all (runs.html), as a
// table that can be sorted and filtered. What it shows stands in data/runs.js and data/cells.js.
"use strict";

const LIMIT = 500;  // rows shown at once
const element = (id) => document.getElementById(id);
const view = { runs: [], column: 0, down: false };
let all = null, cells = null;

// Called by data/runs.js and data/cells.js.
function slalomRuns(data) { all = data; }
function slalomCells(data) { cells = data; }

function cellOf(text, parent, name = "td") {
  const cell = document.createElement(name);
  cell.textContent = text;
  parent.appendChild(cell);
  return cell;
}

// What stands in column `column` of a run: texts first, then numbers; null where not available.
function fieldOf(run, column) {
  const [scenario, method, repetition, outcome, ...values] = run;
  if (column === 0) return all.scenarios[scenario][1];
  if (column === 1) return all.methods[method];
  if (column === 2) return repetition;
  if (column === 3) return all.outcomes[outcome];
  return values[column - 4];
}

function before(a, b) {
  if (a === null || b === null) return (a === null) - (b === null);
  return typeof a === "number" ? a - b : a.localeCompare(b, "en", { numeric: true });
}

function shown() {
  const words = element("filter").value.toLowerCase().split(/\s+/).filter(Boolean);
  const text = (run) => [0, 1, 2, 3].map((column) => fieldOf(run, column)).join(" ").toLowerCase();
  const runs = view.runs.filter((run) => words.every((word) => text(run).includes(word)));
  const sign = view.down ? -1 : 1;
  return runs.sort((a, b) => sign * before(fieldOf(a, view.column), fieldOf(b, view.column)));
}

function addRow(run, body) {
  const row = document.createElement("tr"), name = cellOf("", row, "th"), link = document.createElement("a");
  link.textContent = fieldOf(run, 0);
  link.href = "run.html#" + encodeURI(all.scenarios[run[0]][0] + "/" + fieldOf(run, 1) + "/" + run[2]);
  name.appendChild(link);
  for (let column = 1; column < 4 + all.columns.length; ++column) {
    const value = fieldOf(run, column);
    cellOf(value === null ? "NA" : String(value), row).className = value === null ? "na" : "";
  }
  body.appendChild(row);
}

function show() {
  const runs = shown(), body = element("rows");
  body.replaceChildren();
  for (const run of runs.slice(0, LIMIT)) addRow(run, body);
  element("count").textContent =
    runs.length + " runs" + (runs.length > LIMIT ? ", the first " + LIMIT + " are shown" : "");
  document.body.dataset.ready = String(runs.length);
}

function addHeader() {
  const names = ["scenario", "method", "repetition", "outcome", ...all.columns], row = element("header");
  row.replaceChildren();
  names.forEach((name, column) => {
    const button = document.createElement("button");
    button.textContent = name;
    button.addEventListener("click", () => {
      view.down = view.column === column && !view.down;
      view.column = column;
      show();
    });
    cellOf("", row, "th").appendChild(button);
  });
}

function choose() {
  const found = /^#cell-(\d+)$/.exec(location.hash), cell = found ? cells[Number(found[1])] : null;
  if (found && !cell) {
    element("title").textContent = "This report has no such cell";
    view.runs = [];
  } else {
    element("title").textContent = cell ? cell.title : "All runs";
    view.runs = cell ? cell.runs.map((index) => all.runs[index]) : all.runs.slice();
  }
  show();
}

window.addEventListener("load", () => {
  if (!all || !cells) {
    element("title").textContent = "The data folder of this report is missing";
    return;
  }
  addHeader();
  element("filter").addEventListener("input", show);
  window.addEventListener("hashchange", choose);
  choose();
});
