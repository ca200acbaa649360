// SPDX-License-Identifier: BSD-3-Clause
// Draws index.html (the whole campaign), method.html#INDEX (one method, from 1) and, with clusters.js, cluster.html from
// the data of report.json.
"use strict";

// Draws sections, [id, title, content, open]; those without content are left out.
function showSections(sections) {
  const shown = sections.filter(([, , content]) => content !== null);
  element("report").replaceChildren(...shown.map((section) => fold(...section)), ...(report.footnote ? [soft(report.footnote)] : []), ...report.notes.map((note) => soft(note)));
  return shown;
}

// Opens the sections that answer first; the rest opens by a click, a link or an address.
function showCampaign() {
  if (document.querySelector("[data-failure]")) loadScript("data/failures.js");
  const shown = showSections([
    ["clusters", "Failures", clustersSection(), true], ["summary", "Summary", summarySection(null), report.selected],
    ["findings", "Findings", findingsSection(), false], ["tables", "Cross tables", tablesSection(null), false],
    ["comparisons", "Pairwise comparisons", comparisonSection(null), false],
    ["completion", "Completion", completionSection(), false], ["ranks", "Ranks and profiles", rankingSection(), false],
    ["maps", "Maps", mapSection(null), false], ["scenarios", "Scenarios", gallerySection, false],
    ["repeat", "Reproducibility", repeatSection, false]]);
  element("navigation").replaceChildren(html("div", {}, shown.map(([id, title]) => html("a", { href: "#" + id }, title)),
    html("a", { href: "explore.html" }, "Explore"), html("a", { href: "runs.html" }, "All runs"), foldButton()));
  const follow = () => {
    if (location.hash.startsWith("#s-")) showScenario(location.hash.slice(3));
    followAddress();
  };
  window.addEventListener("hashchange", follow);
  follow();
}

function showMethod() {
  const index = Math.min(report.methods.length, Math.max(1, Number(location.hash.slice(1)) || 1)) - 1;
  const name = methodLabel(index);
  document.title = report.campaign + ": " + name;
  element("title").textContent = name;
  element("campaign").textContent = "Report of " + report.campaign;
  element("runs").href = listOf(methodWord(index));
  element("others").replaceChildren(...report.methods.map((_, i) =>
    i === index ? "" : [" · ", html("a", { href: "method.html#" + (i + 1) }, methodLabel(i))]).flat().filter(Boolean));
  showSections([
    ["overview", "At a glance", overviewSection(index), true],
    ["summary", "Summary", summarySection(index), true], ["outcomes", "Outcomes", outcomesSection(index), true],
    ["comparisons", "Comparisons with the other methods", comparisonSection(index), true],
    ["tables", "Results by descriptor", tablesSection(index), true], ["maps", "Maps", mapSection(index), true],
    ["validity", "Difficulty factors", validitySection(index), false]]);
}

if (!report.summary || !report.runs) {
  element("problem").hidden = false;
} else if (element("navigation")) {
  showCampaign();
} else if (element("report").dataset.page === "cluster") {
  showCluster();
  window.addEventListener("hashchange", showCluster);
} else {
  showMethod();
  window.addEventListener("hashchange", showMethod);
}
