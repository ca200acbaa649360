// SPDX-License-Identifier: BSD-3-Clause
// Ray casting in a scenario: the distance from (x, y) along (dx, dy) to the nearest obstacle, at most `range`.
"use strict";

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
  for (const disc of scenario.discs.concat(scenario.present || [])) nearest = Math.min(nearest, rayToCircle(x, y, dx, dy, disc));
  for (const polygon of scenario.polygons) nearest = Math.min(nearest, rayToPolygon(x, y, dx, dy, polygon));
  if (scenario.grid) nearest = Math.min(nearest, rayThroughCells(x, y, dx, dy, range, scenario.grid));
  return Math.max(0, nearest);
}
