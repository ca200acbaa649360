// SPDX-License-Identifier: BSD-3-Clause
// Shared by all pages: the report's data, builders of elements, texts. Works from a local file, without a network.
"use strict";

const report = {};
// Called by data/summary.js and data/runs.js, each with some of the fields of report.json.
function slalomReport(part) { Object.assign(report, part); }

const element = (id) => document.getElementById(id);

// Children are nodes, texts, or lists of them; null and attributes that are null are left out.
function build(node, attributes, children) {
  for (const [key, value] of Object.entries(attributes || {})) if (value !== null) node.setAttribute(key, value);
  node.append(...children.flat(Infinity).filter((child) => child !== null && child !== ""));
  return node;
}
const html = (name, attributes, ...children) => build(document.createElement(name), attributes, children);
const svg = (name, attributes, ...children) =>
  build(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);

// `number` with `digits` after the point; ties go to the even digit, as in the tables of slalom-analyze.
function fixed(number, digits) {
  const scaled = number * 10 ** digits;
  const isTie = Number.isInteger(number * 2 ** (digits + 1)) && Math.abs(scaled % 1) === 0.5;
  return (isTie ? (2 * Math.round(scaled / 2)) / 10 ** digits : number).toFixed(digits);
}

const plural = (n, noun) => `${n} ${noun}${n === 1 ? "" : "s"}`;

// A script that calls a function of the page with data: scripts can be loaded from a local file, JSON cannot.
function loadScript(source, failed) {
  if (typeof loadPacked === "function") return loadPacked(source, failed);
  const script = html("script", { src: source });
  script.onerror = failed;
  document.head.append(script);
}

// "HASH8/METHOD/REPETITION", encoded for an address.
const runId = (hash, method, repetition) => `${hash.slice(0, 8)}/${encodeURIComponent(method)}/${repetition}`;

// The kind of an outcome, a class of the style sheet: each kind has its own color, symbol and pattern of bars.
const OUTCOME_KINDS = { success: "good", collision: "hit", left_workspace: "left", timeout: "late", stuck: "stuck" };
const outcomeKind = (outcome) => OUTCOME_KINDS[outcome] || (outcome.startsWith("method_") ? "fault" : "odd");

// With a symbol, so that color is not the only cue; `href` of its runs.
function outcomeChip(outcome, count, title, href) {
  const kind = outcomeKind(outcome);
  const sign = { good: "✓", hit: "✕", left: "↦", late: "◷", stuck: "‖", fault: "!", odd: "?" }[kind];
  return html(href ? "a" : "span", { class: "chip " + kind, title: title || null, href: href || null }, sign + " " + outcome + (count ? " " + count : ""));
}

const unitText = (quantity) => (quantity.unit === "-" ? "" : ` [${quantity.unit}]`);

// The address after "#" is a place and settings, each of which may be missing: "cell-12&filter=stuck&sort=density".
function readAddress() {
  const parts = location.hash.slice(1).split("&").filter(Boolean), settings = {};
  const place = parts.length > 0 && !parts[0].includes("=") ? parts.shift() : "";
  for (const part of parts) {
    const [key, ...rest] = part.split("=");
    try { settings[key] = decodeURIComponent(rest.join("=")); } catch (error) { settings[key] = ""; }
  }
  return { place, settings };
}

// Settings that are empty are left out.
function addressOf(place, settings) {
  const set = Object.entries(settings).filter(([, value]) => value !== "");
  return "#" + [place, ...set.map(([key, value]) => key + "=" + encodeURIComponent(value))].filter(Boolean).join("&");
}

// So that the address of the page can be shared; not a step of the browser's history.
const writeAddress = (place, settings) => history.replaceState(null, "", addressOf(place, settings));

// A word of a command for a shell.
const shellWord = (text) => (/^[\w.\/@:+-]+$/.test(text) ? text : "'" + text.replaceAll("'", "'\\''") + "'");

// A command for a terminal, with a button that copies it.
function commandLine(text) {
  const code = html("pre", { class: "command" }, text);
  const button = html("button", { class: "copy" }, "Copy");
  button.addEventListener("click", async () => {
    getSelection().selectAllChildren(code);  // stays selected where the clipboard is not accessible
    const done = navigator.clipboard ? await navigator.clipboard.writeText(text).then(() => true, () => false) : false;
    button.textContent = done || document.execCommand("copy") ? "Copied" : "Press Ctrl+C";
  });
  return html("div", { class: "copied" }, code, button);
}
