// SPDX-License-Identifier: BSD-3-Clause
// The page of many runs: those of one number of a table (runs.html#cell-12) or all (runs.html), as a table that can be
// sorted, filtered and extended by any metric or descriptor. The address has the choices.
"use strict";

const STEP = 100;  // rows that are displayed at first, and more at a time
const TEXT_COLUMNS = ["scenario", "method", "repetition", "outcome"];
const view = { place: "", runs: [], filter: "", sort: "scenario", down: false, columns: [], limit: STEP };
const collator = new Intl.Collator("en", { numeric: true });

// Numbers in whose order the runs are sorted by a field: places of texts, values, and NaN for missing ones.
const keys = new Map();
function sortKeys(id) {
  if (keys.has(id)) return keys.get(id);
  const values = field(id), isText = Object.hasOwn(TEXT_FIELDS, id) && id !== "repetition";
  const places = new Map(isText ? [...new Set(values)].sort(collator.compare).map((text, place) => [text, place]) : []);
  keys.set(id, values.map((value) => (isText ? places.get(value) : typeof value === "number" ? value : NaN)));
  return keys.get(id);
}

// Missing values are last in both directions.
function shownRuns() {
  const order = sortKeys(view.sort), sign = view.down ? -1 : 1;
  const compare = (a, b) => Number.isNaN(order[a]) - Number.isNaN(order[b]) || sign * (order[a] - order[b]) || a - b;
  return filterRuns(view.runs, view.filter).sort(compare);
}

function valueNode(run, id) {
  const value = field(id)[run];
  return typeof value === "number" ? html("td", {}, String(value)) : html("td", { class: "na" }, "NA: " + value);
}

function rowOf(run) {
  return html("tr", {}, html("th", {}, html("a", { href: runAddress(run) }, field("scenario")[run])),
    html("td", {}, field("method")[run]), html("td", {}, String(field("repetition")[run])),
    html("td", {}, outcomeChip(field("outcome")[run], 0, field("detail")[run])), view.columns.map((id) => valueNode(run, id)));
}

function headerOf(id) {
  const quantity = quantityOf(id), isSorted = view.sort === id, arrow = isSorted ? (view.down ? " ▼" : " ▲") : "";
  const button = html("button", { "data-sort": id }, id + (quantity ? unitText(quantity) : ""), html("span", { class: "arrow" }, arrow));
  button.addEventListener("click", () => {
    view.down = isSorted && !view.down;
    view.sort = id;
    show();
    document.querySelector(`[data-sort="${id}"]`).focus();
  });
  return html("th", { "aria-sort": isSorted ? (view.down ? "descending" : "ascending") : null, title: quantity && quantity.name }, button);
}

function show() {
  let runs = [], problem = "";
  try { runs = shownRuns(); } catch (text) { problem = String(text); }
  element("header").replaceChildren(...[...TEXT_COLUMNS, ...view.columns].map(headerOf));
  element("rows").replaceChildren(...runs.slice(0, view.limit).map(rowOf));
  element("count").textContent = problem || plural(runs.length, "run") +
    (runs.length > view.limit ? ", showing the first " + view.limit : "");
  element("more").hidden = runs.length <= view.limit;
  document.body.dataset.ready = String(runs.length);
  const columns = view.columns.join() === report.columns.map(({ id }) => id).join() ? "" : view.columns.join() || "none";
  writeAddress(view.place, { filter: view.filter, sort: view.sort === "scenario" ? "" : view.sort, down: view.down ? "1" : "", columns });
}

// The columns named in the address, as far as they exist.
function columnsOf(text) {
  if (!text) return report.columns.map(({ id }) => id);
  return text.split(",").filter((id) => quantityOf(id));
}

function selectRuns() {
  const { place, settings } = readAddress(), found = /^cell-(\d+)$/.exec(place), cell = found ? report.groups[Number(found[1])] : null;
  const all = found && !cell ? [] : cell ? cell.runs : report.runs.map((_, index) => index);
  const title = found && !cell ? "This report does not contain this cell" : cell ? cell.title : "All runs";
  element("title").textContent = title;
  document.title = title + " - Slalom";
  const sort = settings.sort && field(settings.sort) ? settings.sort : "scenario";
  Object.assign(view, { place, runs: all, filter: settings.filter || "", sort, down: settings.down === "1",
                        columns: columnsOf(settings.columns), limit: STEP });
  element("filter").value = view.filter;
  show();
}

// Adds or removes a column.
function chooseColumn(event) {
  const id = event.target.value;
  view.columns = view.columns.includes(id) ? view.columns.filter((one) => one !== id) : [...view.columns, id];
  event.target.value = "";
  show();
}

function startPage() {
  element("filter").addEventListener("input", (event) => { view.filter = event.target.value; view.limit = STEP; show(); });
  element("more").addEventListener("click", () => { view.limit += STEP; show(); });
  element("columns").append(...[...allQuantities().values()].map(({ id, name }) => html("option", { value: id, title: name }, id)));
  element("columns").addEventListener("change", chooseColumn);
  window.addEventListener("hashchange", selectRuns);
  selectRuns();
}

if (report.columns && report.runs && report.values) startPage();
else element("title").textContent = "The data folder of this report is missing";
