// SPDX-License-Identifier: BSD-3-Clause
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

// The waypoints of a person as those of a mover: t, x, y, ...
function decodePerson(person) {
  const [t, x, y] = ["t", "x", "y"].map((key) => decode(person[key], 0.001));
  return Object.assign({}, person, { waypoints: t.flatMap((at, i) => [at, x[i], y[i]]) });
}

function decodeRun(run) {
  const track = {};
  for (const key of ["t", "x", "y", "h", "v", "w", "c"]) track[key] = decode(run[key], 0.001);
  return Object.assign({}, run, track, { people: (run.people || []).map(decodePerson) });
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

// The state of the run at a time, interpolated linearly between the stored samples.
function stateAt(run, time) {
  let i = 1;
  while (i < run.t.length - 1 && run.t[i] < time) ++i;
  const j = Math.max(0, i - 1), span = run.t[i] - run.t[j];
  const fraction = span > 0 ? Math.min(1, Math.max(0, (time - run.t[j]) / span)) : 0;
  const mix = (values) => values[j] + fraction * (values[i] - values[j]);
  return { x: mix(run.x), y: mix(run.y), v: mix(run.v), w: mix(run.w), c: mix(run.c), h: mix(run.h) };
}

function showTime() {
  const { scenario, run, time } = state;
  if (!run.t.length) return;
  const current = stateAt(run.t.length > 1 ? run : repeatSample(run), time);
  moveMovers(scenario, run.people, time);
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
    const value = run.values[i], explore = "explore.html" + addressOf("", { metric: id });
    return html("tr", {}, html("th", { title: name }, html("a", { href: explore }, id)), typeof value === "number"
      ? html("td", {}, value + (unit === "-" ? "" : " " + unit)) : html("td", { class: "na" }, "NA: " + scenario.reasons[value[0]]));
  }));
  oneTabStop(element("values").parentNode);
}

function showRunList(scenario) {
  element("runs").replaceChildren(...scenario.runs.map((run) => html("li", {},
    html("a", { href: "#" + runId(scenario.id, run.method, run.repetition), "aria-current": run === state.run ? "true" : null,
                style: `border-left: 0.8em solid ${run.color}; padding-left: 0.4em` }, runKey(run)),
    html("span", { class: "soft" }, " " + run.outcome))));
}

function drawTracks(scenario) {
  const { track, others, people, robot } = scenario.layers, run = state.run;
  track.setAttribute("d", pathOf(scenario, run.x, run.y));
  track.setAttribute("stroke", run.color);
  robot.setAttribute("stroke", run.color);
  robot.setAttribute("fill", run.color);
  people.replaceChildren(...run.people.map((person) => drawMover(scenario, person, PERSON)));
  const shown = element("others").checked ? scenario.runs.filter((other) => other !== run) : [];
  others.replaceChildren(...shown.map((other) => svg("path", { d: pathOf(scenario, other.x, other.y), stroke: other.color })));
  showLegend();
}

const showLegend = () => element("legend").replaceChildren(...sceneLegend(state.scenario, state.run));

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
  element("command").replaceChildren(commandLine(
    `slalom-simulate verify ${shellWord(report.results)} --run ${shellWord(scenario.id + "/" + runKey(run))}`));
  element("method").href = "method.html#" + (report.methods.findIndex(({ name }) => name === run.method) + 1);
  const rawlog = element("rawlog");
  rawlog.hidden = !run.rawlog;
  if (run.rawlog) rawlog.querySelector("a").href = run.rawlog;
  element("time").max = String(run.t[run.t.length - 1] || 0);
  drawTracks(scenario);
  fitRun();
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

// Space plays and pauses, unless it is for a button, a link or a field.
document.addEventListener("keydown", (event) => {
  if (event.key !== " " || !state.run || event.target.closest("a, button, input, select, summary, [tabindex]:not(#scene)")) return;
  event.preventDefault();
  setPlaying(!state.playing);
});
element("play").addEventListener("click", () => setPlaying(!state.playing));
element("time").addEventListener("input", (event) => { state.time = Number(event.target.value); showTime(); });
element("scan").addEventListener("change", () => { showTime(); showLegend(); });
element("others").addEventListener("change", () => drawTracks(state.scenario));
window.addEventListener("hashchange", load);
listenToView();
load();
