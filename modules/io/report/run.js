// The page of one run: the place, the way the robot took, a slider through time with the scan at
// that moment, clearance and speed, and every value that is known. What it shows stands in
// data/s-HASH8.js, which calls slalomScenario(); `metrics` comes from data/metrics.js. Works from a file, without a network.
"use strict";

const SVG = "http://www.w3.org/2000/svg";
const element = (id) => document.getElementById(id);
const state = { place: null, run: null, time: 0, playing: false, last: 0 };

function make(name, attributes, parent, text) {
  const node = document.createElementNS(SVG, name);
  for (const key in attributes) node.setAttribute(key, attributes[key]);
  if (text !== undefined) node.textContent = text;
  if (parent) parent.appendChild(node);
  return node;
}

function html(name, text, parent, className) {
  const node = document.createElement(name);
  if (text !== undefined) node.textContent = text;
  if (className) node.className = className;
  if (parent) parent.appendChild(node);
  return node;
}

function fail(message) {
  element("problem").textContent = message;
  element("problem").hidden = false;
  element("viewer").hidden = true;
}

// ---- data -------------------------------------------------------------------------------------

// Whole numbers, each as the difference from the one before it, in units of `unit`.
function decode(differences, unit) {
  let sum = 0;
  return differences.map((difference) => (sum += difference) * unit);
}

function decodeRun(run) {
  const track = {};
  for (const key of ["t", "x", "y", "h", "v", "w", "c"]) track[key] = decode(run[key], 0.001);
  return Object.assign({}, run, track);
}

// The place in cells: run lengths, free first, row by row from below.
function decodeCells(grid) {
  const cells = new Uint8Array(grid.nx * grid.ny);
  let at = 0, value = 0;
  for (const length of grid.runs) {
    if (value) cells.fill(1, at, at + length);
    at += length;
    value = 1 - value;
  }
  return cells;
}

// ---- ray casting: distance from (x, y) along (dx, dy) to what stands there, at most `range` ----

function rayToCircle(x, y, dx, dy, [cx, cy, r]) {
  const fx = x - cx, fy = y - cy, b = fx * dx + fy * dy, c = fx * fx + fy * fy - r * r;
  if (c <= 0) return 0;
  const root = b * b - c;
  return root < 0 || b > 0 ? Infinity : -b - Math.sqrt(root);
}

function rayToSegment(x, y, dx, dy, ax, ay, bx, by) {
  const ex = bx - ax, ey = by - ay, det = dx * ey - dy * ex;
  if (det === 0) return Infinity;
  const t = ((ax - x) * ey - (ay - y) * ex) / det, s = ((ax - x) * dy - (ay - y) * dx) / det;
  return t >= 0 && s >= 0 && s <= 1 ? t : Infinity;
}

function rayToPolygon(x, y, dx, dy, points) {
  let nearest = Infinity;
  for (let i = 0; i < points.length; i += 2) {
    const j = (i + 2) % points.length;
    nearest = Math.min(nearest, rayToSegment(x, y, dx, dy, points[i], points[i + 1], points[j], points[j + 1]));
  }
  return nearest;
}

function rayThroughCells(x, y, dx, dy, range, grid) {
  const unit = grid.resolution;
  const px = (x - grid.x) / unit, py = (y - grid.y) / unit;
  let cx = Math.floor(px), cy = Math.floor(py), distance = 0;
  const stepX = dx > 0 ? 1 : -1, stepY = dy > 0 ? 1 : -1;
  const eachX = Math.abs(1 / dx), eachY = Math.abs(1 / dy);
  let nextX = dx === 0 ? Infinity : (dx > 0 ? cx + 1 - px : px - cx) * eachX;
  let nextY = dy === 0 ? Infinity : (dy > 0 ? cy + 1 - py : py - cy) * eachY;
  while (distance * unit < range) {
    if (cx < 0 || cy < 0 || cx >= grid.nx || cy >= grid.ny) break;
    if (grid.cells[cy * grid.nx + cx]) break;
    if (nextX < nextY) { distance = nextX; nextX += eachX; cx += stepX; }
    else { distance = nextY; nextY += eachY; cy += stepY; }
  }
  return distance * unit;
}

function rayRange(place, x, y, angle, range) {
  const dx = Math.cos(angle), dy = Math.sin(angle), [x0, y0, x1, y1] = place.bounds;
  let nearest = Math.min(range, dx > 0 ? (x1 - x) / dx : dx < 0 ? (x0 - x) / dx : Infinity,
                         dy > 0 ? (y1 - y) / dy : dy < 0 ? (y0 - y) / dy : Infinity);
  for (const disc of place.discs) nearest = Math.min(nearest, rayToCircle(x, y, dx, dy, disc));
  for (const polygon of place.polygons) nearest = Math.min(nearest, rayToPolygon(x, y, dx, dy, polygon));
  if (place.grid) nearest = Math.min(nearest, rayThroughCells(x, y, dx, dy, range, place.grid));
  return Math.max(0, nearest);
}

// ---- the picture ------------------------------------------------------------------------------

const toX = (place, x) => (x - place.bounds[0]) * place.scale;
const toY = (place, y) => (place.bounds[3] - y) * place.scale;

function pathOf(place, xs, ys) {
  return xs.map((x, i) => (i ? "L" : "M") + toX(place, x).toFixed(1) + " " + toY(place, ys[i]).toFixed(1)).join("");
}

function pathOfPoints(place, points) {
  const xs = points.filter((_, i) => i % 2 === 0), ys = points.filter((_, i) => i % 2 === 1);
  return pathOf(place, xs, ys);
}

function gridPath(place) {
  const grid = place.grid, size = grid.resolution * place.scale;
  let path = "";
  for (let row = 0; row < grid.ny; ++row) {
    for (let column = 0; column < grid.nx; ++column) {
      if (!grid.cells[row * grid.nx + column]) continue;
      const first = column;
      while (column < grid.nx && grid.cells[row * grid.nx + column]) ++column;
      const x = toX(place, grid.x + first * grid.resolution), y = toY(place, grid.y + row * grid.resolution);
      path += `M${x.toFixed(2)} ${y.toFixed(2)}h${((column - first) * size).toFixed(2)}v${(-size).toFixed(2)}h${(-(column - first) * size).toFixed(2)}z`;
    }
  }
  return path;
}

function drawPlace(place) {
  const svg = element("scene"), width = (place.bounds[2] - place.bounds[0]) * place.scale;
  const height = (place.bounds[3] - place.bounds[1]) * place.scale;
  svg.replaceChildren();
  svg.setAttribute("viewBox", `0 0 ${width.toFixed(0)} ${height.toFixed(0)}`);
  make("rect", { width, height, fill: "#ffffff" }, svg);
  const obstacles = make("g", { fill: "#8a8f98" }, svg);
  for (const [x, y, r] of place.discs)
    make("circle", { cx: toX(place, x), cy: toY(place, y), r: r * place.scale }, obstacles);
  for (const polygon of place.polygons) make("path", { d: pathOfPoints(place, polygon) + "z" }, obstacles);
  if (place.grid) make("path", { d: gridPath(place), "shape-rendering": "crispEdges" }, obstacles);
  const reference = (points, dash, title) => {
    if (points) make("title", {}, make("path", { d: pathOfPoints(place, points), fill: "none", stroke: "#333", "stroke-width": 1.3,
                                                 "stroke-dasharray": dash }, svg), title);
  };
  reference(place.safest, "2 3", "safest path");
  reference(place.shortest, "7 3", "shortest path");
  const goal = make("g", { stroke: "#b00020", "stroke-width": 1.8, fill: "none" }, svg);
  const gx = toX(place, place.goal[0]), gy = toY(place, place.goal[1]), r = Math.max(4, place.radius * place.scale);
  make("circle", { cx: gx, cy: gy, r }, goal);
  make("path", { d: `M${gx - r} ${gy}h${2 * r}M${gx} ${gy - r}v${2 * r}` }, goal);
  place.layers = { scan: make("path", { fill: "#f0b429", "fill-opacity": 0.25, stroke: "#c98a00", "stroke-width": 0.8 }, svg),
                   others: make("g", { fill: "none", "stroke-width": 1.6, opacity: 0.55 }, svg),
                   track: make("path", { fill: "none", "stroke-width": 2.4 }, svg),
                   robot: make("path", { "fill-opacity": 0.35, "stroke-width": 1.8 }, svg) };
}

function robotPath(place, x, y, heading) {
  const cos = Math.cos(heading), sin = Math.sin(heading), at = (px, py) => [x + px * cos - py * sin, y + px * sin + py * cos];
  const outline = place.footprint.length ? place.footprint : null;
  const nose = at(place.radius, 0), arrow = `M${toX(place, x)} ${toY(place, y)}L${toX(place, nose[0])} ${toY(place, nose[1])}`;
  if (!outline) {
    const r = place.radius * place.scale, left = toX(place, x) - r;
    return `M${left} ${toY(place, y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0` + arrow;
  }
  const points = [];
  for (let i = 0; i < outline.length; i += 2) points.push(...at(outline[i], outline[i + 1]));
  return pathOfPoints(place, points) + "z" + arrow;
}

function drawScan(place, x, y, heading) {
  if (!element("scan").checked) return place.layers.scan.setAttribute("d", "");
  const { rays, aperture, range } = place.sensor, points = [x, y];
  for (let i = 0; i < rays; ++i) {
    const angle = heading + (rays > 1 ? -aperture / 2 + (aperture * i) / (rays - 1) : 0);
    const distance = rayRange(place, x, y, angle, range);
    points.push(x + distance * Math.cos(angle), y + distance * Math.sin(angle));
  }
  place.layers.scan.setAttribute("d", pathOfPoints(place, points) + "z");
}

// ---- time -------------------------------------------------------------------------------------

const angleDifference = (a, b) => Math.atan2(Math.sin(a - b), Math.cos(a - b));

// The run at a moment: straight between the samples kept.
function momentOf(run, time) {
  let i = 1;
  while (i < run.t.length - 1 && run.t[i] < time) ++i;
  const j = Math.max(0, i - 1), span = run.t[i] - run.t[j];
  const share = span > 0 ? Math.min(1, Math.max(0, (time - run.t[j]) / span)) : 0;
  const mix = (values) => values[j] + share * (values[i] - values[j]);
  return { x: mix(run.x), y: mix(run.y), v: mix(run.v), w: mix(run.w), c: mix(run.c),
           h: run.h[j] + share * angleDifference(run.h[i], run.h[j]) };
}

function showMoment() {
  const { place, run, time } = state;
  if (!run.t.length) return;
  const now = momentOf(run.t.length > 1 ? run : repeatSample(run), time);
  drawScan(place, now.x, now.y, now.h);
  place.layers.robot.setAttribute("d", robotPath(place, now.x, now.y, now.h));
  element("time").value = String(time);
  element("moment").textContent =
    `t ${time.toFixed(2)} s · x ${now.x.toFixed(2)} m, y ${now.y.toFixed(2)} m · v ${now.v.toFixed(2)} m/s, ` +
    `w ${now.w.toFixed(2)} rad/s · clearance ${now.c.toFixed(2)} m`;
  for (const id of ["clearance", "speed"]) moveCursor(element(id), run, time);
}

function repeatSample(run) {
  const twice = {};
  for (const key of ["t", "x", "y", "h", "v", "w", "c"]) twice[key] = [run[key][0], run[key][0]];
  return twice;
}

function play(now) {
  if (!state.playing) return;
  const end = state.run.t[state.run.t.length - 1] || 0;
  state.time = Math.min(end, state.time + ((now - state.last) / 1000) * Number(element("pace").value));
  state.last = now;
  showMoment();
  if (state.time >= end) return setPlaying(false);
  requestAnimationFrame(play);
}

function setPlaying(playing) {
  state.playing = playing;
  element("play").textContent = playing ? "Pause" : "Play";
  if (!playing) return;
  if (state.time >= (state.run.t[state.run.t.length - 1] || 0)) state.time = 0;
  state.last = performance.now();
  requestAnimationFrame(play);
}

// ---- plots under the picture ------------------------------------------------------------------

const PLOT = { width: 640, height: 120, left: 44, right: 8, top: 8, bottom: 22 };

function plotX(run, t) {
  const end = run.t[run.t.length - 1] || 1;
  return PLOT.left + ((PLOT.width - PLOT.left - PLOT.right) * t) / end;
}

function drawPlot(svg, run, values, label) {
  const low = Math.min(0, ...values), high = Math.max(0.1, ...values);
  const y = (value) => PLOT.top + (PLOT.height - PLOT.top - PLOT.bottom) * (1 - (value - low) / (high - low));
  svg.replaceChildren();
  svg.setAttribute("viewBox", `0 0 ${PLOT.width} ${PLOT.height}`);
  make("title", {}, svg, label);
  for (const value of [low, high]) {
    make("line", { x1: PLOT.left, x2: PLOT.width - PLOT.right, y1: y(value), y2: y(value), class: "rule" }, svg);
    make("text", { x: PLOT.left - 5, y: y(value) + 4, "text-anchor": "end" }, svg, value.toFixed(1));
  }
  const end = run.t[run.t.length - 1] || 0;
  make("text", { x: PLOT.width - PLOT.right, y: PLOT.height - 5, "text-anchor": "end" }, svg, end.toFixed(1) + " s");
  make("text", { x: PLOT.left, y: PLOT.height - 5 }, svg, label);
  const d = values.map((value, i) => (i ? "L" : "M") + plotX(run, run.t[i]).toFixed(1) + " " + y(value).toFixed(1)).join("");
  make("path", { d, fill: "none", stroke: run.color, "stroke-width": 1.8 }, svg);
  make("line", { y1: PLOT.top, y2: PLOT.height - PLOT.bottom, class: "cursor" }, svg);
}

function moveCursor(svg, run, time) {
  const cursor = svg.querySelector(".cursor");
  if (!cursor) return;
  cursor.setAttribute("x1", plotX(run, time));
  cursor.setAttribute("x2", plotX(run, time));
}

// ---- the page ---------------------------------------------------------------------------------

function runKey(run) { return run.method + "/" + run.repetition; }

function showValues(place, run) {
  const body = element("values");
  body.replaceChildren();
  metrics.forEach((metric, i) => {
    const row = html("tr", undefined, body), value = run.values[i];
    html("th", metric.id, row).title = metric.name;
    if (typeof value === "number") html("td", value + (metric.unit === "-" ? "" : " " + metric.unit), row);
    else html("td", "NA: " + place.reasons[value[0]], row, "na");
  });
}

function showRunList(place) {
  const list = element("runs");
  list.replaceChildren();
  for (const run of place.runs) {
    const item = html("li", undefined, list), link = html("a", runKey(run), item);
    link.href = "#" + place.id + "/" + runKey(run);
    link.style.borderLeft = "0.8em solid " + run.color;
    link.style.paddingLeft = "0.4em";
    if (run === state.run) link.setAttribute("aria-current", "true");
    html("span", " " + run.outcome, item, "soft");
  }
}

function drawTracks(place) {
  const { track, others, robot } = place.layers, run = state.run;
  track.setAttribute("d", pathOf(place, run.x, run.y));
  track.setAttribute("stroke", run.color);
  robot.setAttribute("stroke", run.color);
  robot.setAttribute("fill", run.color);
  others.replaceChildren();
  if (!element("others").checked) return;
  for (const other of place.runs)
    if (other !== run) make("path", { d: pathOf(place, other.x, other.y), stroke: other.color }, others);
}

function showRun(run) {
  const place = state.place;
  state.run = run;
  state.time = 0;
  setPlaying(false);
  document.title = place.id + "/" + runKey(run) + " - Slalom";
  element("title").textContent = place.name + ": " + runKey(run);
  element("outcome").textContent = run.outcome + (run.detail ? ": " + run.detail : "");
  element("id").textContent = place.id + "/" + runKey(run);
  element("seed").textContent = run.seed;
  const rawlog = element("rawlog");
  rawlog.hidden = !run.rawlog;
  if (run.rawlog) rawlog.querySelector("a").href = run.rawlog;
  element("time").max = String(run.t[run.t.length - 1] || 0);
  drawTracks(place);
  drawPlot(element("clearance"), run, run.c, "clearance (m)");
  drawPlot(element("speed"), run, run.v, "speed (m/s)");
  showValues(place, run);
  showRunList(place);
  showMoment();
  document.body.dataset.ready = runKey(run);
}

// Called by data/s-HASH8.js.
function slalomScenario(data) {
  const place = Object.assign({}, data, { runs: data.runs.map(decodeRun) });
  if (place.grid) place.grid.cells = decodeCells(place.grid);
  place.scale = 640 / Math.max(place.bounds[2] - place.bounds[0], place.bounds[3] - place.bounds[1]);
  state.place = place;
  element("scenario").href = place.page;
  drawPlace(place);
  chooseRun();
}

function wanted() {
  const [id, method, repetition] = decodeURIComponent(location.hash.slice(1)).split("/");
  return { id, key: method + "/" + repetition };
}

function chooseRun() {
  const { key } = wanted(), run = state.place.runs.find((candidate) => runKey(candidate) === key);
  if (!run) return fail("This report has no run " + wanted().id + "/" + key + ".");
  element("problem").hidden = true;
  element("viewer").hidden = false;
  showRun(run);
}

function load() {
  const { id } = wanted();
  if (!/^[0-9a-f]{8}$/.test(id)) return fail("The address names no run: run.html#HASH8/METHOD/REPETITION.");
  if (state.place && state.place.id === id) return chooseRun();
  const script = document.createElement("script");
  script.src = "data/s-" + id + ".js";
  script.onerror = () => fail("This report has no scenario " + id + ".");
  document.head.appendChild(script);
}

element("play").addEventListener("click", () => setPlaying(!state.playing));
element("time").addEventListener("input", (event) => { state.time = Number(event.target.value); showMoment(); });
element("scan").addEventListener("change", showMoment);
element("others").addEventListener("change", () => drawTracks(state.place));
window.addEventListener("hashchange", load);
load();
