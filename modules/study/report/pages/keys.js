// SPDX-License-Identifier: BSD-3-Clause
// Tables of links are one stop of the tab key; arrow keys, Home and End move within them.
"use strict";

const FOCUSABLE = "a[href], summary, button";

// Makes one link of `table` reachable by the tab key: the first, then the one that had the focus last.
function oneTabStop(table) {
  const items = table.querySelectorAll(FOCUSABLE);
  if (items.length < 2) return table;
  table.dataset.keys = "arrows";
  items.forEach((item, i) => item.setAttribute("tabindex", i === 0 ? "0" : "-1"));
  return table;
}

const isShown = (item) => item.getClientRects().length > 0 && item.checkVisibility();
const shownIn = (node) => [...node.querySelectorAll(FOCUSABLE)].filter(isShown);

// The link of the nearest row above (step -1) or below (1) in the same column, or the first one of that row.
function besideRow(table, item, step) {
  const rows = [...table.rows], cell = item.closest("th, td");
  for (let at = rows.indexOf(cell.parentNode) + step; at >= 0 && at < rows.length; at += step) {
    const found = rows[at].cells[cell.cellIndex] ? shownIn(rows[at].cells[cell.cellIndex]) : [];
    if (found.length > 0) return found[0];
    if (shownIn(rows[at]).length > 0) return shownIn(rows[at])[0];
  }
  return item;
}

function nextByKey(table, item, key) {
  const items = shownIn(table), at = items.indexOf(item);
  if (key === "ArrowRight") return items[Math.min(at + 1, items.length - 1)];
  if (key === "ArrowLeft") return items[Math.max(at - 1, 0)];
  if (key === "Home") return items[0];
  if (key === "End") return items[items.length - 1];
  if (key === "ArrowUp" || key === "ArrowDown") return besideRow(table, item, key === "ArrowUp" ? -1 : 1);
  return null;
}

document.addEventListener("keydown", (event) => {
  const table = event.target.closest("table[data-keys]");
  if (!table || event.ctrlKey || event.altKey || event.metaKey) return;
  const next = nextByKey(table, event.target, event.key);
  if (!next) return;
  event.preventDefault();
  table.querySelectorAll("[tabindex='0']").forEach((one) => one.setAttribute("tabindex", "-1"));
  next.setAttribute("tabindex", "0");
  next.focus();
});
