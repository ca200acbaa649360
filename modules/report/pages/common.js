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
  const script = html("script", { src: source });
  script.onerror = failed;
  document.head.append(script);
}

// "HASH8/METHOD/REPETITION", encoded for an address.
const runId = (hash, method, repetition) => `${hash.slice(0, 8)}/${encodeURIComponent(method)}/${repetition}`;

function outcomeClass(outcome) {
  if (outcome === "success") return "good";
  if (outcome === "collision" || outcome === "left_workspace") return "hit";
  if (outcome === "timeout" || outcome === "stuck") return "late";
  return outcome.startsWith("method_") ? "fault" : "odd";
}

// With a symbol, so that color is not the only cue.
function outcomeChip(outcome, count, title) {
  const kind = outcomeClass(outcome), sign = { good: "✓", hit: "✕", late: "◷", fault: "!", odd: "?" }[kind];
  return html("span", { class: "chip " + kind, title: title || null }, sign + " " + outcome + (count ? " " + count : ""));
}
