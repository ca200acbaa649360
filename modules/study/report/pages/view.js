// SPDX-License-Identifier: BSD-3-Clause
// The view of the picture of a run: fitted to the run, moved and zoomed by wheel, pointers, keys and buttons; its scale bar.
"use strict";

const FIT_MARGIN = 2;  // m, around the path and the goal
const BORDER = 0.2;  // m, beyond the workspace, so that its border is seen
const LEAST_VIEW = 0.5;  // m, the smaller side of the closest view

// Boxes are [left, top, width, height] in coordinates of the picture.
const view = { box: [0, 0, 1, 1], pointers: new Map() };

function showView(box) {
  view.box = box;
  element("scene").setAttribute("viewBox", box.map((value) => value.toFixed(2)).join(" "));
  showScale();
}

function fitWorkspace() {
  const { bounds, scale } = state.scenario;
  showView([0, 0, (bounds[2] - bounds[0]) * scale, (bounds[3] - bounds[1]) * scale]);
}

// The path of the run and the goal with a margin, as far as the workspace reaches.
function fitRun() {
  const { scenario, run, rival } = state, { bounds, scale } = scenario, other = rival || { x: [], y: [] };
  if (run.x.length === 0) return fitWorkspace();
  const range = (values, low, high) =>
    [Math.max(low - BORDER, Math.min(...values) - FIT_MARGIN), Math.min(high + BORDER, Math.max(...values) + FIT_MARGIN)];
  const [left, right] = range([...run.x, ...other.x, scenario.goal[0]], bounds[0], bounds[2]);
  const [bottom, top] = range([...run.y, ...other.y, scenario.goal[1]], bounds[1], bounds[3]);
  showView([toX(scenario, left), toY(scenario, top), (right - left) * scale, (top - bottom) * scale]);
}

// Enlarges about a point of the picture, which stays where it is.
function zoomView(factor, x, y) {
  const [left, top, width, height] = view.box, { bounds, scale } = state.scenario;
  const largest = 1.5 * scale * Math.max(bounds[2] - bounds[0], bounds[3] - bounds[1]);
  const least = Math.min(1, Math.max(width, height) / largest), most = Math.max(1, Math.min(width, height) / (LEAST_VIEW * scale));
  const by = Math.min(most, Math.max(least, factor));
  showView([x - (x - left) / by, y - (y - top) / by, width / by, height / by]);
}

const zoomCenter = (factor) => zoomView(factor, view.box[0] + view.box[2] / 2, view.box[1] + view.box[3] / 2);
const moveView = (dx, dy) => showView([view.box[0] + dx, view.box[1] + dy, view.box[2], view.box[3]]);

// The point of the picture below a pointer.
function scenePoint({ clientX, clientY }) {
  const point = new DOMPoint(clientX, clientY).matrixTransform(element("scene").getScreenCTM().inverse());
  return [point.x, point.y];
}

// The bar is as long as 1, 2 or 5 times a power of ten of meters, at most a quarter of the picture.
function showScale() {
  const scene = element("scene"), matrix = scene.getScreenCTM(), width = scene.getBoundingClientRect().width;
  if (!state.scenario || !matrix || width === 0) return;
  const pixels = matrix.a * state.scenario.scale, longest = width / 4 / pixels, power = 10 ** Math.floor(Math.log10(longest));
  const meters = power * (longest >= 5 * power ? 5 : longest >= 2 * power ? 2 : 1);
  element("scale").firstElementChild.style.width = (meters * pixels).toFixed(1) + "px";
  element("scale").lastElementChild.textContent = Number(meters.toPrecision(1)) + " m";
}

// Center and spread of the pressed pointers, in coordinates of the picture.
function grip() {
  const points = [...view.pointers.values()].map(scenePoint), n = points.length;
  const [x, y] = [0, 1].map((i) => points.reduce((sum, point) => sum + point[i], 0) / n);
  return { x, y, spread: n > 1 ? Math.hypot(points[0][0] - points[1][0], points[0][1] - points[1][1]) : 0 };
}

// One pointer moves the picture; two also enlarge it by their distance.
function dragView(event) {
  if (!view.pointers.has(event.pointerId)) return;
  const before = grip();
  view.pointers.set(event.pointerId, { clientX: event.clientX, clientY: event.clientY });
  const after = grip();
  moveView(before.x - after.x, before.y - after.y);
  if (before.spread > 0 && after.spread > 0) zoomView(after.spread / before.spread, before.x, before.y);
}

const VIEW_KEYS = { "+": () => zoomCenter(1.25), "-": () => zoomCenter(0.8), 0: () => fitRun(),
                    ArrowLeft: () => moveView(-view.box[2] / 10, 0), ArrowRight: () => moveView(view.box[2] / 10, 0),
                    ArrowUp: () => moveView(0, -view.box[3] / 10), ArrowDown: () => moveView(0, view.box[3] / 10) };

function listenToView() {
  const scene = element("scene");
  const release = (event) => view.pointers.delete(event.pointerId);
  scene.addEventListener("wheel", (event) => {
    event.preventDefault();  // the page stays
    const pixels = event.deltaY * (event.deltaMode === 0 ? 1 : 30);
    zoomView(Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.002)), ...scenePoint(event));  // a pinch on a touchpad has ctrlKey
  }, { passive: false });
  scene.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    if (event.isTrusted) scene.setPointerCapture(event.pointerId);
    view.pointers.set(event.pointerId, { clientX: event.clientX, clientY: event.clientY });
  });
  scene.addEventListener("pointermove", dragView);
  for (const name of ["pointerup", "pointercancel"]) scene.addEventListener(name, release);
  scene.addEventListener("keydown", (event) => {
    if (!VIEW_KEYS[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    VIEW_KEYS[event.key]();
  });
  const buttons = { closer: () => zoomCenter(1.5), farther: () => zoomCenter(1 / 1.5), fit: fitRun, whole: fitWorkspace };
  for (const [id, action] of Object.entries(buttons)) element(id).addEventListener("click", action);
  new ResizeObserver(showScale).observe(scene);
}
