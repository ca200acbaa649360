// SPDX-License-Identifier: BSD-3-Clause
// Fields of each run, by name: texts, metrics and descriptors; and filters of runs in these words.
"use strict";

const TEXT_FIELDS = {
  scenario: (run) => report.scenarios[run[0]].name, method: (run) => report.methods[run[1]].name,
  repetition: (run) => run[2], outcome: (run) => report.outcomes[run[3]], detail: (run) => run[4],
};

// All metrics and descriptors, each once.
function allQuantities() {
  const all = new Map();
  for (const quantity of [...report.metrics, ...report.descriptors, ...report.columns])
    if (!all.has(quantity.id)) all.set(quantity.id, quantity);
  return all;
}
const quantityOf = (id) => allQuantities().get(id) || null;

function makeField(id) {
  if (Object.hasOwn(TEXT_FIELDS, id)) return report.runs.map(TEXT_FIELDS[id]);
  const at = (list) => list.findIndex((quantity) => quantity.id === id);
  const metric = at(report.metrics), descriptor = at(report.descriptors), column = at(report.columns);
  const known = (value) => (Array.isArray(value) ? report.reasons[value[0]] : value === null ? "not a number" : value);
  if (metric >= 0) return report.values[metric].map(known);
  if (descriptor >= 0) return report.runs.map((run) => report.scenarios[run[0]].values[descriptor]);
  return column >= 0 ? report.runs.map((run) => run[5 + column]) : null;
}

// A value per run: a number, or a text; for metrics and descriptors the text is the reason why there is no number. Null
// if there is no such field.
const fields = new Map();
function field(id) {
  if (!fields.has(id)) fields.set(id, makeField(id));
  return fields.get(id);
}

const CONDITION = /^([A-Za-z_]\w*)(<=|>=|!=|<|>|=)(.*)$/s;
const WORD = /[A-Za-z_]\w*(?:<=|>=|!=|<|>|=)"(?:[^"\\]|\\.)*"|\S+/g;

function literalOf(text) {
  try { return text.startsWith('"') ? JSON.parse(text) : text; } catch (error) { return text; }
}

// A condition on the runs by index; throws a text for names that do not exist and texts where a number is needed.
function conditionOf(word) {
  const [, id, sign, text] = CONDITION.exec(word), values = field(id), literal = literalOf(text), number = Number(literal);
  if (!values) throw `There is no ${id}; expected scenario, method, repetition, outcome, detail, a metric or a descriptor.`;
  const same = literal.toLowerCase(), isText = Object.hasOwn(TEXT_FIELDS, id) && id !== "repetition";
  const equal = (value) => (isText ? value.toLowerCase() === same
    : same === "na" ? typeof value !== "number" : value === number);
  if (sign === "=") return (run) => equal(values[run]);
  if (sign === "!=") return (run) => !equal(values[run]);
  if (isText || literal === "" || Number.isNaN(number)) throw `${word}: expected a number, such as density<0.2.`;
  const orders = { "<": (value) => value < number, "<=": (value) => value <= number,
                   ">": (value) => value > number, ">=": (value) => value >= number };
  return (run) => typeof values[run] === "number" && orders[sign](values[run]);
}

// Parts of the names of scenario, method and outcome.
let searchTexts = null;
function wordIn(word) {
  searchTexts = searchTexts || report.runs.map((run) =>
    ["scenario", "method", "repetition", "outcome"].map((id) => TEXT_FIELDS[id](run)).join(" ").toLowerCase());
  return (run) => searchTexts[run].includes(word.toLowerCase());
}

// The runs among `runs` (indexes) for which every word of `text` holds: a part of a name, or a condition such as
// method="my method", density<0.2, safety=NA. Throws a text if it cannot be understood.
function filterRuns(runs, text) {
  const conditions = (text.match(WORD) || []).map((word) => (CONDITION.test(word) ? conditionOf(word) : wordIn(word)));
  return runs.filter((run) => conditions.every((holds) => holds(run)));
}

const runAddress = (index) => {
  const [scenario, method, repetition] = report.runs[index];
  return "run.html#" + runId(report.scenarios[scenario].hash, report.methods[method].name, repetition);
};

// Words of filters.
const methodWord = (method) => "method=" + JSON.stringify(report.methods[method].name);
const listOf = (...words) => "runs.html" + addressOf("", { filter: words.join(" ") });
