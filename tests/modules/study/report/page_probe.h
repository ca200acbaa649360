// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace slalom {

/// JavaScript that measures pages of the report in frames of the same origin: `measure(document)`
/// has the height and the width, the number of tab stops, and the least contrast of any text with
/// what lies below it (WCAG 2, 1.4.3; without the text in pictures of scenarios), and where;
/// what ends right of the page, except in tables of cards and the navigation, which scroll; and the
/// headings that are more than one level below the one before.
inline constexpr const char* kPageProbe = R"js(
const rgba = (text) => { const n = text.match(/[\d.]+/g).map(Number); return n.length < 4 ? [...n, 1] : n; };
const over = (top, below) => top.slice(0, 3).map((v, i) => v * top[3] + below[i] * (1 - top[3])).concat(1);
function luminance([r, g, b]) {
  const linear = (v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4);
  return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
}
function contrast(a, b) {
  const [high, low] = [luminance(a), luminance(b)].sort((p, q) => q - p);
  return (high + 0.05) / (low + 0.05);
}
function ground(node, view) {
  const layers = [];
  for (let at = node; at; at = at.parentElement) layers.unshift(rgba(view.getComputedStyle(at).backgroundColor));
  return layers.reduce((below, layer) => over(layer, below), [255, 255, 255, 1]);
}
const isDrawn = (node) => node.checkVisibility() && node.getClientRects().length > 0;
function leastContrast(page) {
  const view = page.defaultView, walk = page.createTreeWalker(page.body, NodeFilter.SHOW_TEXT);
  let least = [21, "no text"], texts = 0;
  for (let text; (text = walk.nextNode());) {
    const node = text.parentElement;
    if (!text.data.trim() || !isDrawn(node) || node.closest(".picture svg, script")) continue;
    const style = view.getComputedStyle(node), below = ground(node, view);
    const ratio = contrast(over(rgba(node.namespaceURI.endsWith("svg") ? style.fill : style.color), below), below);
    if (ratio < least[0]) least = [ratio, text.data];
    ++texts;
  }
  return { contrast: least[0], where: least[1], texts };
}
function outside(page) {
  const right = page.documentElement.clientWidth + 0.5, scrolls = ".card table *, .card table, nav *, svg *";
  return [...page.body.querySelectorAll("*")].filter((node) => isDrawn(node) && !node.matches(scrolls) &&
    node.getBoundingClientRect().right > right).map((node) => node.tagName + " " + node.textContent.slice(0, 40));
}
function skipped(page) {
  const headings = [...page.querySelectorAll("h1, h2, h3, h4, h5, h6")].filter(isDrawn), level = (h) => +h.tagName[1];
  return headings.filter((h, i) => level(h) > (i ? level(headings[i - 1]) : 0) + 1).map((h) => h.textContent);
}
function measure(page) {
  const stops = [...page.querySelectorAll("a[href], button, input, select, summary, iframe, [tabindex]")];
  return Object.assign({ height: page.documentElement.scrollHeight, width: page.documentElement.scrollWidth,
    outside: outside(page), skipped: skipped(page), mains: page.querySelectorAll("main").length, stops: stops.filter((node) => node.tabIndex >= 0 && isDrawn(node)).length }, leastContrast(page));
}
const milliseconds = (action) => { const start = performance.now(); action(); return performance.now() - start; };
function show(result) { document.body.replaceChildren(JSON.stringify(result)); }
)js";

}  // namespace slalom
