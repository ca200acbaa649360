// SPDX-License-Identifier: BSD-3-Clause
// Runs as points of a chart: drawn as one path per method and kind of outcome, found by the pointer or by keys, opened by a
// click, selected by dragging.
"use strict";

// The marks of the kinds of outcomes, as in the pictures of scenarios.
const MARKS = {
  good: (x, y) => `M${x} ${y}h0`, hit: (x, y) => `M${x - 3} ${y - 3}l6 6m0 -6l-6 6`, left: (x, y) => `M${x - 4} ${y}h8m-3 -3l3 3l-3 3`,
  late: (x, y) => `M${x - 3} ${y - 3}h6l-6 6h6z`, stuck: (x, y) => `M${x - 2} ${y - 4}v8m4 0v-8`,
  fault: (x, y) => `M${x} ${y - 4}v8m-4 -4h8`, odd: (x, y) => `M${x - 3} ${y - 3}h6v6h-6z`,
};

// The mark of an outcome with its name, for a legend.
function markItem(outcome) {
  const kind = outcomeKind(outcome);
  return html("span", {}, svg("svg", { class: "chart mark", viewBox: "-6 -6 12 12", "aria-hidden": "true" },
                              svg("path", { class: markClass(kind), d: MARKS[kind](0, 0) })), outcome);
}
const markClass = (kind) => (kind === "good" ? "dots" : "crosses");

// `points`: { x, y } in coordinates of the chart, and `run`.
function drawMarks(points) {
  const paths = new Map();
  for (const { x, y, run } of points) {
    const kind = outcomeKind(field("outcome")[run]), key = report.runs[run][1] + kind;
    if (!paths.has(key)) paths.set(key, { color: report.methods[report.runs[run][1]].color, kind, d: [] });
    paths.get(key).d.push(MARKS[kind](Number(x.toFixed(1)), Number(y.toFixed(1))));
  }
  return [...paths.values()].map(({ color, kind, d }) => svg("path", { class: markClass(kind), d: d.join(""), stroke: color }));
}

// Coordinates of the chart of an event.
function chartPoint(picture, event) {
  const box = picture.getBoundingClientRect(), scale = CHART.width / box.width;
  return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
}

// Dragging draws a box, and calls `select` with the runs of the points in it. Returns whether the last press was such a drag.
function brushMarks(picture, points, select) {
  const box = svg("rect", { class: "brush", visibility: "hidden" });
  let from = null, dragged = false;
  const between = (a, b, value) => Math.min(a, b) <= value && value <= Math.max(a, b);
  const finish = (event) => {
    const to = chartPoint(picture, event);
    if (from && dragged) select(points.filter(({ x, y }) => between(from[0], to[0], x) && between(from[1], to[1], y)).map(({ run }) => run));
    from = null;
  };
  picture.addEventListener("pointerdown", (event) => {
    [from, dragged] = [chartPoint(picture, event), false];
    window.addEventListener("pointerup", finish, { once: true });  // also outside of the chart
  });
  picture.addEventListener("pointermove", (event) => {
    const to = chartPoint(picture, event);
    if (from === null || (!dragged && Math.hypot(to[0] - from[0], to[1] - from[1]) < 6)) return;
    dragged = true;
    for (const [key, value] of Object.entries({ visibility: "visible", x: Math.min(from[0], to[0]), y: Math.min(from[1], to[1]),
                                                width: Math.abs(to[0] - from[0]), height: Math.abs(to[1] - from[1]) }))
      box.setAttribute(key, value);
  });
  picture.addEventListener("pointercancel", () => { from = null; });
  picture.append(box);
  return () => dragged;
}

// Shows the nearest point under the pointer, or the next one by arrow keys, in `note`; a click or Enter opens its run.
function pickMarks(picture, points, note, textOf, wasDragged) {
  const ring = svg("circle", { class: "ring", r: 7, visibility: "hidden" });
  let at = -1;
  const order = points.slice().sort((a, b) => a.x - b.x || a.y - b.y);
  const show = (index) => {
    at = index;
    ring.setAttribute("visibility", at < 0 ? "hidden" : "visible");
    picture.style.cursor = at < 0 ? "" : "pointer";
    if (at < 0) return;
    ring.setAttribute("cx", order[at].x);
    ring.setAttribute("cy", order[at].y);
    note.replaceChildren(html("a", { href: runAddress(order[at].run), tabindex: "-1" }, textOf(order[at].run)));
  };
  const nearest = (event) => {
    const [x, y] = chartPoint(picture, event);
    let found = -1, least = 15 * 15;  // square pixels
    order.forEach((point, i) => {
      const distance = (point.x - x) ** 2 + (point.y - y) ** 2;
      if (distance < least) [found, least] = [i, distance];
    });
    return found;
  };
  const open = () => { if (at >= 0) note.querySelector("a").click(); };
  picture.addEventListener("pointermove", (event) => show(nearest(event)));
  picture.addEventListener("click", (event) => {
    if (wasDragged()) return;
    show(nearest(event));
    open();
  });
  picture.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (event.key === "Enter") open();
    if (!step || order.length === 0) return;
    event.preventDefault();
    show((at + step + order.length) % order.length);
  });
  picture.setAttribute("tabindex", "0");
  picture.append(ring);
}

// A chart of points with the text of the chosen one below it; `select` gets the runs of a dragged box.
function markChart(picture, points, textOf, select) {
  const note = html("p", { class: "support", role: "status" }, "Point at a run, or move with the arrow keys; a click or Enter opens it. " +
                    "Drag a box to see the scenarios of its runs.");
  picture.append(...drawMarks(points));
  pickMarks(picture, points, note, textOf, brushMarks(picture, points, select));
  return [picture, note];
}
