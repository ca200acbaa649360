// The page of one run: the scenario, the trajectory, a time slider with the scan at that time, clearance
// and speed, and all values. The data is in data/s-HASH8.js, which calls slalomScenario(), and data/summary.js.
"use strict";

const state = { scenario: null, run: null, time: 0, playing: false, last: 0 };

function fail(message) {
  element("problem").textContent = message;
  element("problem").hidden = false;
  element("viewer").hidden = true;
}

// ---- data -------------------------------------------------------------------------------------

// Decodes integer differences between consecutive values, in units of `unit`.
function decode(differences, unit) {
  let sum = 0;
  return differences.map((difference) => (sum += difference) * unit);
}

function decodeRun(run) {
  const track = {};
  for (const key of ["t", "x", "y", "h", "v", "w", "c"]) track[key] = decode(run[key], 0.001);
  return Object.assign({}, run, track);
}

// Decodes grid cells: run lengths, starting with free cells, row by row from the bottom.
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

// ---- ray casting: distance from (x, y) along (dx, dy) to the nearest obstacle, at most `range` --

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

function rayRange(scenario, x, y, angle, range) {
  const dx = Math.cos(angle), dy = Math.sin(angle), [x0, y0, x1, y1] = scenario.bounds;
  let nearest = Math.min(range, dx > 0 ? (x1 - x) / dx : dx < 0 ? (x0 - x) / dx : Infinity,
                         dy > 0 ? (y1 - y) / dy : dy < 0 ? (y0 - y) / dy : Infinity);
  for (const disc of scenario.discs) nearest = Math.min(nearest, rayToCircle(x, y, dx, dy, disc));
  for (const polygon of scenario.polygons) nearest = Math.min(nearest, rayToPolygon(x, y, dx, dy, polygon));
  if (scenario.grid) nearest = Math.min(nearest, rayThroughCells(x, y, dx, dy, range, scenario.grid));
  return Math.max(0, nearest);
}

// ---- the picture ------------------------------------------------------------------------------

const toX = (scenario, x) => (x - scenario.bounds[0]) * scenario.scale;
const toY = (scenario, y) => (scenario.bounds[3] - y) * scenario.scale;

function pathOf(scenario, xs, ys) {
  return xs.map((x, i) => (i ? "L" : "M") + toX(scenario, x).toFixed(1) + " " + toY(scenario, ys[i]).toFixed(1)).join("");
}

function pathOfPoints(scenario, points) {
  const xs = points.filter((_, i) => i % 2 === 0), ys = points.filter((_, i) => i % 2 === 1);
  return pathOf(scenario, xs, ys);
}

function gridPath(scenario) {
  const grid = scenario.grid, size = grid.resolution * scenario.scale;
  let path = "";
  for (let row = 0; row < grid.ny; ++row) {
    for (let column = 0; column < grid.nx; ++column) {
      if (!grid.cells[row * grid.nx + column]) continue;
      const first = column;
      while (column < grid.nx && grid.cells[row * grid.nx + column]) ++column;
      const x = toX(scenario, grid.x + first * grid.resolution), y = toY(scenario, grid.y + row * grid.resolution);
      path += `M${x.toFixed(2)} ${y.toFixed(2)}h${((column - first) * size).toFixed(2)}v${(-size).toFixed(2)}h${(-(column - first) * size).toFixed(2)}z`;
    }
  }
  return path;
}

function drawScenario(scenario) {
  const width = (scenario.bounds[2] - scenario.bounds[0]) * scenario.scale;
  const height = (scenario.bounds[3] - scenario.bounds[1]) * scenario.scale;
  const disc = ([x, y, r]) => svg("circle", { cx: toX(scenario, x), cy: toY(scenario, y), r: r * scenario.scale });
  const polygon = (points) => svg("path", { d: pathOfPoints(scenario, points) + "z" });
  const reference = (points, dash, title) => (points ? svg("path", { d: pathOfPoints(scenario, points), fill: "none",
    stroke: "#333", "stroke-width": 1.3, "stroke-dasharray": dash }, svg("title", {}, title)) : null);
  const gx = toX(scenario, scenario.goal[0]), gy = toY(scenario, scenario.goal[1]), r = Math.max(4, scenario.radius * scenario.scale);
  const layers = { scan: svg("path", { fill: "#f0b429", "fill-opacity": 0.25, stroke: "#c98a00", "stroke-width": 0.8 }),
                   others: svg("g", { fill: "none", "stroke-width": 1.6, opacity: 0.55 }),
                   track: svg("path", { fill: "none", "stroke-width": 2.4 }),
                   robot: svg("path", { "fill-opacity": 0.35, "stroke-width": 1.8 }) };
  scenario.layers = layers;
  element("scene").setAttribute("viewBox", `0 0 ${width.toFixed(0)} ${height.toFixed(0)}`);
  element("scene").replaceChildren(svg("rect", { width, height, fill: "#ffffff" }),
    svg("g", { fill: "#8a8f98" }, scenario.discs.map(disc), scenario.polygons.map(polygon),
        scenario.grid ? svg("path", { d: gridPath(scenario), "shape-rendering": "crispEdges" }) : null),
    svg("g", {}, reference(scenario.safest, "2 3", "safest path"), reference(scenario.shortest, "7 3", "shortest path")),
    svg("g", { stroke: "#b00020", "stroke-width": 1.8, fill: "none" }, svg("circle", { cx: gx, cy: gy, r }),
        svg("path", { d: `M${gx - r} ${gy}h${2 * r}M${gx} ${gy - r}v${2 * r}` })),
    layers.scan, layers.others, layers.track, layers.robot);
}

function robotPath(scenario, x, y, heading) {
  const cos = Math.cos(heading), sin = Math.sin(heading), at = (px, py) => [x + px * cos - py * sin, y + px * sin + py * cos];
  const outline = scenario.footprint.length ? scenario.footprint : null;
  const nose = at(scenario.radius, 0), arrow = `M${toX(scenario, x)} ${toY(scenario, y)}L${toX(scenario, nose[0])} ${toY(scenario, nose[1])}`;
  if (!outline) {
    const r = scenario.radius * scenario.scale, left = toX(scenario, x) - r;
    return `M${left} ${toY(scenario, y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0` + arrow;
  }
  const points = [];
  for (let i = 0; i < outline.length; i += 2) points.push(...at(outline[i], outline[i + 1]));
  return pathOfPoints(scenario, points) + "z" + arrow;
}

function drawScan(scenario, x, y, heading) {
  if (!element("scan").checked) return scenario.layers.scan.setAttribute("d", "");
  const { rays, aperture, range } = scenario.sensor, points = [x, y];
  for (let i = 0; i < rays; ++i) {
    const angle = heading + (rays > 1 ? -aperture / 2 + (aperture * i) / (rays - 1) : 0);
    const distance = rayRange(scenario, x, y, angle, range);
    points.push(x + distance * Math.cos(angle), y + distance * Math.sin(angle));
  }
  scenario.layers.scan.setAttribute("d", pathOfPoints(scenario, points) + "z");
}

// ---- time -------------------------------------------------------------------------------------

const angleDifference = (a, b) => Math.atan2(Math.sin(a - b), Math.cos(a - b));

// The state of the run at a time, interpolated linearly between the stored samples.
function stateAt(run, time) {
  let i = 1;
  while (i < run.t.length - 1 && run.t[i] < time) ++i;
  const j = Math.max(0, i - 1), span = run.t[i] - run.t[j];
  const fraction = span > 0 ? Math.min(1, Math.max(0, (time - run.t[j]) / span)) : 0;
  const mix = (values) => values[j] + fraction * (values[i] - values[j]);
  return { x: mix(run.x), y: mix(run.y), v: mix(run.v), w: mix(run.w), c: mix(run.c),
           h: run.h[j] + fraction * angleDifference(run.h[i], run.h[j]) };
}

function showTime() {
  const { scenario, run, time } = state;
  if (!run.t.length) return;
  const current = stateAt(run.t.length > 1 ? run : repeatSample(run), time);
  drawScan(scenario, current.x, current.y, current.h);
  scenario.layers.robot.setAttribute("d", robotPath(scenario, current.x, current.y, current.h));
  element("time").value = String(time);
  element("state").textContent =
    `t ${time.toFixed(2)} s · x ${current.x.toFixed(2)} m, y ${current.y.toFixed(2)} m · v ${current.v.toFixed(2)} m/s, ` +
    `w ${current.w.toFixed(2)} rad/s · clearance ${current.c.toFixed(2)} m`;
  for (const id of ["clearance", "speed"]) moveCursor(id, time);
}

function repeatSample(run) {
  const twice = {};
  for (const key of ["t", "x", "y", "h", "v", "w", "c"]) twice[key] = [run[key][0], run[key][0]];
  return twice;
}

function play(now) {
  if (!state.playing) return;
  const end = state.run.t[state.run.t.length - 1] || 0;
  state.time = Math.min(end, state.time + ((now - state.last) / 1000) * Number(element("playback_speed").value));
  state.last = now;
  showTime();
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

function drawPlot(id, run, values, label) {
  const plot = chart({ label: "simulated time (s)", low: 0, high: run.t[run.t.length - 1] || 1 }, axisOf(label, values),
                     [{ label, color: run.color, points: values.map((value, i) => [run.t[i], value]) }], 170);
  plot.append(svg("line", { y1: CHART.top, y2: 170 - CHART.bottom, class: "cursor" }));
  element(id).replaceChildren(plot);
}

function moveCursor(id, time) {
  const plot = element(id).firstChild, cursor = plot.lastChild;
  for (const end of ["x1", "x2"]) cursor.setAttribute(end, plot.toX(time));
}

// ---- the page ---------------------------------------------------------------------------------

function runKey(run) { return run.method + "/" + run.repetition; }

function showValues(scenario, run) {
  element("values").replaceChildren(...report.metrics.map(({ id, name, unit }, i) => {
    const value = run.values[i];
    return html("tr", {}, html("th", { title: name }, id), typeof value === "number"
      ? html("td", {}, value + (unit === "-" ? "" : " " + unit)) : html("td", { class: "na" }, "NA: " + scenario.reasons[value[0]]));
  }));
}

function showRunList(scenario) {
  element("runs").replaceChildren(...scenario.runs.map((run) => html("li", {},
    html("a", { href: "#" + runId(scenario.id, run.method, run.repetition), "aria-current": run === state.run ? "true" : null,
                style: `border-left: 0.8em solid ${run.color}; padding-left: 0.4em` }, runKey(run)),
    html("span", { class: "soft" }, " " + run.outcome))));
}

function drawTracks(scenario) {
  const { track, others, robot } = scenario.layers, run = state.run;
  track.setAttribute("d", pathOf(scenario, run.x, run.y));
  track.setAttribute("stroke", run.color);
  robot.setAttribute("stroke", run.color);
  robot.setAttribute("fill", run.color);
  const shown = element("others").checked ? scenario.runs.filter((other) => other !== run) : [];
  others.replaceChildren(...shown.map((other) => svg("path", { d: pathOf(scenario, other.x, other.y), stroke: other.color })));
}

function showRun(run) {
  const scenario = state.scenario;
  state.run = run;
  state.time = 0;
  setPlaying(false);
  document.title = scenario.id + "/" + runKey(run) + " - Slalom";
  element("title").textContent = scenario.name + ": " + runKey(run);
  element("outcome").textContent = run.outcome + (run.detail ? ": " + run.detail : "");
  element("id").textContent = scenario.id + "/" + runKey(run);
  element("seed").textContent = run.seed;
  const rawlog = element("rawlog");
  rawlog.hidden = !run.rawlog;
  if (run.rawlog) rawlog.querySelector("a").href = run.rawlog;
  element("time").max = String(run.t[run.t.length - 1] || 0);
  drawTracks(scenario);
  drawPlot("clearance", run, run.c, "clearance (m)");
  drawPlot("speed", run, run.v, "speed (m/s)");
  showValues(scenario, run);
  showRunList(scenario);
  showTime();
  document.body.dataset.ready = runKey(run);
}

// Called by data/s-HASH8.js.
function slalomScenario(data) {
  const scenario = Object.assign({}, data, { runs: data.runs.map(decodeRun) });
  if (scenario.grid) scenario.grid.cells = decodeCells(scenario.grid);
  scenario.scale = 640 / Math.max(scenario.bounds[2] - scenario.bounds[0], scenario.bounds[3] - scenario.bounds[1]);
  state.scenario = scenario;
  element("scenario").href = scenario.page;
  drawScenario(scenario);
  selectRun();
}

function requested() {
  const [id, method, repetition] = location.hash.slice(1).split("/").map(decodeURIComponent);
  return { id, key: method + "/" + repetition };
}

function selectRun() {
  const { key } = requested(), run = state.scenario.runs.find((candidate) => runKey(candidate) === key);
  if (!run) return fail("This report does not contain run " + requested().id + "/" + key + ".");
  element("problem").hidden = true;
  element("viewer").hidden = false;
  showRun(run);
}

function load() {
  const { id } = requested();
  if (!/^[0-9a-f]{8}$/.test(id)) return fail("The address contains no run; expected run.html#HASH8/METHOD/REPETITION.");
  if (state.scenario && state.scenario.id === id) return selectRun();
  loadScript("data/s-" + id + ".js", () => fail("This report does not contain scenario " + id + "."));
}

element("play").addEventListener("click", () => setPlaying(!state.playing));
element("time").addEventListener("input", (event) => { state.time = Number(event.target.value); showTime(); });
element("scan").addEventListener("change", showTime);
element("others").addEventListener("change", () => drawTracks(state.scenario));
window.addEventListener("hashchange", load);
load();
