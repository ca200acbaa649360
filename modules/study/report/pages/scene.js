// SPDX-License-Identifier: BSD-3-Clause
// The picture of a run: the scenario, the reference paths, and layers for scan, tracks and robot.
"use strict";

const toX = (scenario, x) => (x - scenario.bounds[0]) * scenario.scale;
const toY = (scenario, y) => (scenario.bounds[3] - y) * scenario.scale;

function pathOf(scenario, xs, ys) {
  return xs.map((x, i) => (i ? "L" : "M") + toX(scenario, x).toFixed(2) + " " + toY(scenario, ys[i]).toFixed(2)).join("");
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

// Center of a moving obstacle at a time of the run; null while it is absent.
function moverAt({ waypoints, after }, time) {
  const first = waypoints[0], last = waypoints[waypoints.length - 3];
  if (time < first || (time > last && after === "vanish")) return null;
  let t = Math.min(time, last), i = 0;
  if (after === "loop" && last > first) t = first + ((time - first) % (last - first));
  while (i + 3 < waypoints.length - 3 && waypoints[i + 3] <= t) i += 3;
  const [t0, x0, y0, t1 = t0, x1 = x0, y1 = y0] = waypoints.slice(i, i + 6);
  const fraction = t1 > t0 ? (t - t0) / (t1 - t0) : 0;
  return [x0 + fraction * (x1 - x0), y0 + fraction * (y1 - y0)];
}

// Moves the discs of movers and people; `present` has those that the robot sees, as x, y, radius.
function moveMovers(scenario, people, time) {
  const { layers } = scenario, discs = [layers.movers, layers.people].flatMap((layer) => [...layer.querySelectorAll("circle")]);
  scenario.present = [];
  (scenario.movers || []).concat(people).forEach((mover, i) => {
    const disc = discs[i], at = moverAt(mover, time);
    disc.setAttribute("visibility", at ? "visible" : "hidden");
    if (!at) return;
    disc.setAttribute("cx", toX(scenario, at[0]).toFixed(2));
    disc.setAttribute("cy", toY(scenario, at[1]).toFixed(2));
    scenario.present.push([at[0], at[1], mover.radius]);
  });
}

const MOVER = { title: "moving obstacle ", fill: "#e0a030", stroke: "#8a5a00" };
const PERSON = { title: "person ", fill: "#a78bda", stroke: "#4b2e83" };

// The lines of the picture, as its legend shows them.
const LOOKS = {
  track: { fill: "none", "stroke-width": 2.4 }, others: { fill: "none", "stroke-width": 1.6, opacity: 0.55 },
  rival: { fill: "none", "stroke-width": 2.4, "stroke-dasharray": "6 3" },
  shortest: { class: "reference", "stroke-width": 1.3, "stroke-dasharray": "7 3", title: "shortest path" },
  safest: { class: "reference", "stroke-width": 1.3, "stroke-dasharray": "2 3", title: "safest path" },
  scan: { fill: "#f0b429", "fill-opacity": 0.25, stroke: "#c98a00", "stroke-width": 0.8 },
  goal: { class: "goal", "stroke-width": 1.8, fill: "none" }, border: { class: "border", "stroke-width": 1.5, fill: "none" },
};

// The path and the disc of a mover or a person.
function drawMover(scenario, { id, radius, waypoints }, { title, fill, stroke }) {
  const points = waypoints.filter((_, i) => i % 3 > 0);
  return svg("g", {}, svg("title", {}, title + id), svg("path", { d: pathOfPoints(scenario, points), fill: "none",
    stroke, "stroke-dasharray": "4 2" }), svg("circle", { r: radius * scenario.scale, fill, stroke }));
}

function goalHeading(scenario, x, y, length) {
  const heading = scenario.goal_heading;
  return heading === undefined ? null
    : svg("path", { d: `M${x} ${y}L${x + length * Math.cos(heading)} ${y - length * Math.sin(heading)}` });
}

function drawScenario(scenario) {
  const width = (scenario.bounds[2] - scenario.bounds[0]) * scenario.scale;
  const height = (scenario.bounds[3] - scenario.bounds[1]) * scenario.scale;
  const disc = ([x, y, r]) => svg("circle", { cx: toX(scenario, x), cy: toY(scenario, y), r: r * scenario.scale });
  const polygon = (points) => svg("path", { d: pathOfPoints(scenario, points) + "z" });
  const reference = (points, { title, ...look }) => (points ? svg("path", { d: pathOfPoints(scenario, points), ...look },
                                                                  svg("title", {}, title)) : null);
  const gx = toX(scenario, scenario.goal[0]), gy = toY(scenario, scenario.goal[1]), r = scenario.radius * scenario.scale;
  const layers = { scan: svg("path", LOOKS.scan),
                   others: svg("g", LOOKS.others),
                   track: svg("path", LOOKS.track),
                   movers: svg("g", {}, (scenario.movers || []).map((mover) => drawMover(scenario, mover, MOVER))),
                   people: svg("g", {}),  // of the shown run
                   rivalTrack: svg("path", LOOKS.rival), rivalRobot: svg("path", { "fill-opacity": 0.15, "stroke-width": 1.8 }),
                   robot: svg("path", { "fill-opacity": 0.35, "stroke-width": 1.8 }) };
  scenario.layers = layers;
  element("scene").replaceChildren(svg("rect", { class: "workspace", width, height }),
    svg("g", { class: "obstacles" }, scenario.discs.map(disc), scenario.polygons.map(polygon),
        scenario.grid ? svg("path", { d: gridPath(scenario), "shape-rendering": "crispEdges" }) : null),
    svg("g", {}, reference(scenario.safest, LOOKS.safest), reference(scenario.shortest, LOOKS.shortest)),
    svg("rect", { ...LOOKS.border, width, height }), svg("g", LOOKS.goal, svg("circle", { cx: gx, cy: gy, r }),
        svg("path", { d: `M${gx - r} ${gy}h${2 * r}M${gx} ${gy - r}v${2 * r}` }), goalHeading(scenario, gx, gy, 1.6 * r)),
    layers.scan, layers.movers, layers.people, layers.others, layers.rivalTrack, layers.track, layers.rivalRobot, layers.robot);
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
  const cos = Math.cos(heading), sin = Math.sin(heading);
  const fans = scenario.lasers.map((laser) => {
    const fromX = x + laser.x * cos - laser.y * sin, fromY = y + laser.x * sin + laser.y * cos;
    const { rays, aperture, range } = laser, points = [fromX, fromY];
    for (let i = 0; i < rays; ++i) {
      const angle = heading + laser.yaw + (rays > 1 ? -aperture / 2 + (aperture * i) / (rays - 1) : 0);
      const distance = rayRange(scenario, fromX, fromY, angle, range);
      points.push(fromX + distance * Math.cos(angle), fromY + distance * Math.sin(angle));
    }
    return pathOfPoints(scenario, points) + "z";
  });
  scenario.layers.scan.setAttribute("d", fans.join(""));
}

// The legend of what is drawn for a run, and for the one that it is compared with, if any.
function sceneLegend(scenario, run, rival) {
  const item = (text, ...shapes) => html("span", {}, svg("svg", { width: 34, height: 12, "aria-hidden": "true" }, shapes), text);
  const lineOf = (look, text) => item(text, svg("path", { d: "M1 6H33", ...look, title: null }));
  const area = (look, text) => item(text, svg("rect", { x: 1, y: 1, width: 32, height: 10, ...look }));
  const disc = ({ fill, stroke }, text) =>
    item(text, svg("path", { d: "M1 6H33", stroke, "stroke-dasharray": "4 2" }), svg("circle", { cx: 17, cy: 6, r: 5, fill, stroke }));
  const shown = (key) => element(key).checked;
  return [lineOf({ ...LOOKS.track, stroke: run.color }, runKey(run) + ", robot and its heading"),
    rival ? lineOf({ ...LOOKS.rival, stroke: rival.color }, runKey(rival) + ", at the same time") : "",
    shown("others") && scenario.runs.length > 1 ? lineOf({ ...LOOKS.others, stroke: "currentColor" }, "other runs here, in the colors of their list") : "",
    scenario.shortest ? lineOf(LOOKS.shortest, LOOKS.shortest.title) : "", scenario.safest ? lineOf(LOOKS.safest, LOOKS.safest.title) : "",
    shown("scan") ? area(LOOKS.scan, "scan") : "", (scenario.movers || []).length > 0 ? disc(MOVER, "moving obstacle, its path") : "",
    run.people.length > 0 ? disc(PERSON, "person, its path in " + (rival ? runKey(run) : "this run")) : "",
    item("goal", svg("path", { ...LOOKS.goal, d: "M12 6a5 5 0 1 0 10 0a5 5 0 1 0 -10 0M12 6H22M17 1V11" })),
    area({ class: "obstacles" }, "obstacle"), area(LOOKS.border, "border of the workspace")].filter(Boolean);
}
