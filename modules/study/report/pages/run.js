// SPDX-License-Identifier: BSD-3-Clause
// The page of one run: the scenario, the trajectory, a time slider with the scan at that time, clearance
// and speed, and all values. The data is in data/s-HASH8.js, which calls slalomScenario(), and data/summary.js.
"use strict";

// `rival`: the run in the same scenario that is compared, at the same time; null for none.
const state = { scenario: null, run: null, rival: null, time: 0, playing: false, last: 0 };

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
  let i = Math.min(1, run.t.length - 1);
  while (i < run.t.length - 1 && run.t[i] < time) ++i;
  const j = Math.max(0, i - 1), span = run.t[i] - run.t[j];
  const fraction = span > 0 ? Math.min(1, Math.max(0, (time - run.t[j]) / span)) : 0;
  const mix = (values) => values[j] + fraction * (values[i] - values[j]);
  return { x: mix(run.x), y: mix(run.y), v: mix(run.v), w: mix(run.w), c: mix(run.c), h: mix(run.h) };
}

const endOf = (run) => (run && run.t.length > 0 ? run.t[run.t.length - 1] : 0);
const endOfBoth = () => Math.max(endOf(state.run), endOf(state.rival));

// Draws the robot of a run at a time and describes its state.
function showRobot(layer, text, run, time) {
  const { x, y, v, w, c, h } = stateAt(run, time);
  layer.setAttribute("d", robotPath(state.scenario, x, y, h));
  text.textContent = (state.rival ? runKey(run) + ": " : "") + `t ${Math.min(time, endOf(run)).toFixed(2)} s · x ${x.toFixed(2)} m, ` +
    `y ${y.toFixed(2)} m · v ${v.toFixed(2)} m/s, w ${w.toFixed(2)} rad/s · clearance ${c.toFixed(2)} m`;
  return { x, y, h };
}

function showTime() {
  const { scenario, run, rival, time } = state;
  if (!run.t.length) return;
  moveMovers(scenario, run.people, time);
  const { x, y, h } = showRobot(scenario.layers.robot, element("state"), run, time);
  drawScan(scenario, x, y, h);
  if (rival) showRobot(scenario.layers.rivalRobot, element("rival_state"), rival, time);
  element("time").value = String(time);
  for (const id of ["clearance", "speed"]) moveCursor(id, time);
}

function play(now) {
  if (!state.playing) return;
  const end = endOfBoth();
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
  if (state.time >= endOfBoth()) state.time = 0;
  state.last = performance.now();
  requestAnimationFrame(play);
}

// ---- plots under the picture ------------------------------------------------------------------

// Draws the values `key` of both runs over time.
function drawPlot(id, key, label) {
  const runs = [state.rival, state.run].filter(Boolean);
  const plot = chart({ label: "simulated time (s)", low: 0, high: endOfBoth() || 1 }, axisOf(label, runs.flatMap((run) => run[key])),
                     runs.map((run) => ({ label: runKey(run), color: run.color, points: run[key].map((value, i) => [run.t[i], value]) })), 170);
  plot.append(svg("line", { y1: CHART.top, y2: 170 - CHART.bottom, class: "cursor" }));
  element(id).replaceChildren(plot);
}

function moveCursor(id, time) {
  const plot = element(id).firstChild, cursor = plot.lastChild;
  for (const end of ["x1", "x2"]) cursor.setAttribute(end, plot.toX(time));
}

// ---- the page ---------------------------------------------------------------------------------

function runKey(run) { return run.method + "/" + run.repetition; }

function showValues(scenario) {
  const runs = [state.run, state.rival].filter(Boolean);
  const cell = (value, unit) => (typeof value === "number"
    ? html("td", {}, value + (unit === "-" ? "" : " " + unit)) : html("td", { class: "na" }, "NA: " + scenario.reasons[value[0]]));
  element("compared").replaceChildren(...(state.rival ? [html("tr", {}, html("th"), runs.map((run) => html("th", {}, runKey(run))))] : []));
  element("values").replaceChildren(...report.metrics.map(({ id, name, unit }, i) => {
    const explore = "explore.html" + addressOf("", { metric: id });
    return html("tr", {}, html("th", { title: name }, html("a", { href: explore }, id)), runs.map((run) => cell(run.values[i], unit)));
  }));
  oneTabStop(element("values").parentNode);
}

function showRunList(scenario) {
  element("runs").replaceChildren(...scenario.runs.map((run) => html("li", {},
    html("a", { href: "#" + runId(scenario.id, run.method, run.repetition), "aria-current": run === state.run ? "true" : null,
                style: `border-left: 0.8em solid ${run.color}; padding-left: 0.4em` }, runKey(run)),
    html("span", { class: "soft" }, " " + run.outcome))));
}

function drawTrack(track, robot, run) {
  track.setAttribute("d", run ? pathOf(state.scenario, run.x, run.y) : "");
  for (const layer of [track, robot]) layer.setAttribute("stroke", run ? run.color : "none");
  robot.setAttribute("fill", run ? run.color : "none");
}

function drawTracks(scenario) {
  const { track, rivalTrack, rivalRobot, others, people, robot } = scenario.layers, run = state.run;
  drawTrack(track, robot, run);
  drawTrack(rivalTrack, rivalRobot, state.rival);
  people.replaceChildren(...run.people.map((person) => drawMover(scenario, person, PERSON)));
  const shown = element("others").checked ? scenario.runs.filter((other) => other !== run && other !== state.rival) : [];
  others.replaceChildren(...shown.map((other) => svg("path", { d: pathOf(scenario, other.x, other.y), stroke: other.color })));
  showLegend();
}

const showLegend = () => element("legend").replaceChildren(...sceneLegend(state.scenario, state.run, state.rival));

function showRun(run, rival) {
  const scenario = state.scenario;
  state.run = run;
  state.rival = rival;
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
  rawlog.hidden = !run.rawlog || typeof loadPacked === "function";
  if (run.rawlog) rawlog.querySelector("a").href = run.rawlog;
  const choices = scenario.runs.filter((other) => other !== run && other.t.length > 0);
  element("rival").replaceChildren(html("option", { value: "" }, "no other run"), ...choices.map((other) =>
    html("option", { value: runKey(other) }, runKey(other) + ": " + other.outcome)));
  element("rival").value = rival ? runKey(rival) : "";
  element("rival_state").textContent = "";
  element("time").max = String(endOfBoth());
  drawTracks(scenario);
  fitRun();
  drawPlot("clearance", "c", "clearance (m)");
  drawPlot("speed", "v", "speed (m/s)");
  showValues(scenario);
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
  const { place, settings } = readAddress(), [id = "", method, repetition] = place.split("/").map(decodeURIComponent);
  return { id, key: method + "/" + repetition, rival: settings.with };
}

function selectRun() {
  const { key, rival } = requested(), find = (wanted) => state.scenario.runs.find((candidate) => runKey(candidate) === wanted);
  const run = find(key);
  if (!run) return fail("This report does not contain run " + requested().id + "/" + key + ".");
  element("problem").hidden = true;
  element("viewer").hidden = false;
  showRun(run, rival && rival !== key ? find(rival) || null : null);
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
element("rival").addEventListener("change", (event) => { location.hash = addressOf(readAddress().place, { with: event.target.value }); });
window.addEventListener("hashchange", load);
listenToView();
load();
