// SPDX-License-Identifier: BSD-3-Clause
// Clusters of failures: their section of index.html, and cluster.html#INDEX (from 1). Uses the builders of report.js.
"use strict";

const clusterName = (cluster) => `${plural(cluster.members.length, "failure")}: ${cluster.name}`;
const statements = (cluster) => cluster.statements.map((text) => finding(text, true));

function clustersSection() {
  if (report.clusters.length === 0) return null;
  const item = (cluster, i) => card(
    html("h3", { class: "title" }, html("a", { href: "cluster.html#" + (i + 1) }, clusterName(cluster))), statements(cluster),
    html("p", { class: "support" }, cluster.basis));
  return report.clusters.map(item);
}

const runLink = (index) => html("a", { href: runAddress(index) }, report.scenarios[report.runs[index][0]].name);

// Three significant digits, without an exponent where that is short.
const short = (number) => String(Number(number.toPrecision(3)));
const rangeText = ([low, high]) => `${short(low)} to ${short(high)}`;

function contrastRow(one) {
  const interval = one.interval ? ` [${short(one.interval[0])}, ${short(one.interval[1])}]` : "";
  const fields = [rangeText(one.failures), rangeText(one.neighbors), short(one.difference) + interval,
                  `${one.higher} / ${one.lower} of ${one.pairs}`, one.p_text];
  return html("tr", { class: one.holds ? "holds" : null },
    html("th", {}, one.name + unitText(one), html("br"), html("code", {}, one.id)), fields.map((text) => html("td", {}, text)));
}

function contrastsTable(contrasts) {
  if (contrasts.length === 0) return null;
  return card(tableOf({}, ["Quantity", "Failures", "Successful neighbors", "Difference", "Higher / lower", "p (Holm)"].map(heading),
                      contrasts.map(contrastRow)));
}

function contrastsSection(cluster) {
  const parts = [contrastsTable(cluster.scenarios),
                 cluster.runs.length === 0 ? null : [html("h3", {}, "In the runs"),
                   soft("What the robot did differently: mostly a consequence of the failure, not its cause."),
                   contrastsTable(cluster.runs)]];
  return [soft("Quartiles of the failures and of their successful neighbors; the difference is the Hodges-Lehmann estimate " +
               "with its interval, p is that of the signed-rank test. Contrasts that hold are first, and bold."), parts];
}

// The replay of a run, in a frame.
const replay = (index) => html("iframe", { class: "replay", title: "Replay of the run", src: runAddress(index) });

function memberRow(member) {
  const [, , , outcome, detail] = report.runs[member.run];
  return html("tr", {}, html("th", {}, runLink(member.run)), html("td", {}, outcomeChip(report.outcomes[outcome], 0, detail)),
    html("td", { class: "wrap" }, member.departure),
    html("td", {}, member.found), html("td", {}, member.compared === member.run ? "-" : runLink(member.compared)),
    html("td", {}, member.neighbors.map((run, i) => [i > 0 ? ", " : "", runLink(run)])));
}

function membersSection(cluster) {
  const header = ["Smallest scenario", "Outcome", "Departure", "Found", "Original", "Successful neighbors"].map(heading);
  const figures = cluster.members.map(({ run }) => {
    const scenario = report.runs[run][0];
    return figureOf(report.scenarios[scenario], report.runs.filter((one) => one[0] === scenario));
  });
  return [card(tableOf({}, header, cluster.members.map(memberRow))), galleryLegend(), html("div", { class: "gallery" }, figures)];
}

function showCluster() {
  const index = Number(location.hash.slice(1)) || 1, cluster = report.clusters[index - 1];
  if (!cluster) {
    element("title").textContent = "This report does not contain this cluster";
    return element("report").replaceChildren();
  }
  document.title = report.campaign + ": " + cluster.name;
  element("title").textContent = clusterName(cluster);
  element("campaign").textContent = "Report of " + report.campaign;
  const first = cluster.members[0];
  showSections([
    ["statements", "What distinguishes them", [statements(cluster), soft(cluster.basis)], true],
    ["replay", "A run: " + report.scenarios[report.runs[first.run][0]].name, replay(first.run), true],
    ["command", "The command that repeats it", commandLine(first.command), true],
    ["contrasts", "Failures against successful neighbors", contrastsSection(cluster), true],
    ["members", "Smallest scenarios", membersSection(cluster), true]]);
  const pages = new Set(cluster.members.map(({ run }) => report.scenarios[report.runs[run][0]].page));
  for (const page of pages) loadScript(`data/pictures-${page}.js`);
}
