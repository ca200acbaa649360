// SPDX-License-Identifier: BSD-3-Clause
// Sections that compare methods by curves and ranks, and maps over two descriptors.
"use strict";

const seriesOf = (curves) =>
  curves.map(({ method, points }) => ({ label: methodLabel(method), color: report.methods[method].color, points, steps: true }));

function completionSection() {
  const last = Math.max(0, ...report.completion.flatMap((curve) => curve.points.slice(-1).map(([time]) => time)));
  if (last === 0) return null;
  const series = seriesOf(report.completion.map(({ method, points }) => ({ method, points: [[0, 0], ...points] })));
  return card(html("h3", { class: "title" }, "Fraction of runs that have reached the goal"),
    chart({ label: "simulated time (s)", low: 0, high: last }, fractionAxis("fraction of runs"), series), legend(series),
    html("p", { class: "support" }, "Aalen-Johansen estimate: the other outcomes are competing risks, so that each curve " +
         "ends at the success rate."));
}

function profileCard(profile) {
  const series = seriesOf(profile.curves.map(({ method, points }) =>
    ({ method, points: points.filter(([ratio]) => ratio <= 16) })));
  return card(html("h3", { class: "title" }, "Performance profile of " + profile.metric),
    chart({ label: "ratio to the best method in the scenario", low: 1, high: 16, logarithmic: true },
          fractionAxis("fraction of scenarios"), series), legend(series),
    html("p", { class: "support" }, `Fraction of the ${profile.scenarios} scenarios in which a method is within a ratio of ` +
         "the best one (Dolan and Moré 2002); the value at 1 is the fraction in which it is the best." +
         (profile.left_out ? ` Left out: ${plural(profile.left_out, "scenario")} in which no method has a value.` : "")));
}

function rankCard(ranks) {
  const methods = ranks.methods.map(({ method, rank }) =>
    ({ label: methodLabel(method), color: report.methods[method].color, rank }));
  return card(html("h3", { class: "title" }, "Mean ranks in " + ranks.metric), rankDiagram(methods, ranks.groups, ranks.critical_difference),
    html("p", { class: "support" }, `Friedman test over ${ranks.scenarios} of ${plural(ranks.all_scenarios, "scenario")}: ` +
         `${ranks.p_text}; bars join methods whose mean ranks do not differ by the critical difference (Nemenyi, level ${ranks.level}).` +
         (ranks.left_out ? ` Left out: ${ranks.left_out}.` : "")));
}

function rankingSection() {
  const of = (list, column, draw) => list.filter((one) => one.metric === column.id).map(draw);
  const cards = report.columns.map((column) => [of(report.ranks, column, rankCard), of(report.profiles, column, profileCard)]);
  return cards.flat(2).length > 0 ? cards : null;
}

function mapCard(map) {
  const column = report.columns.find((one) => one.id === map.metric);
  const field = (cell) => {
    if (cell.n + missing(cell) === 0) return html("td", { class: "cell na" }, "–");
    return cellNode(cell, cell.runs, 2, column.rate && enoughToDraw(cell) ? goodness(cell.mean, scaleOf(column, [cell])) : null,
                    support(valuesText(cell)));
  };
  const rows = map.rows.map((bin, i) => html("tr", {}, html("th", {}, bin), map.fields[i].map(field)));
  return card(html("h3", { class: "title" }, methodName(map.method), ": " + map.metric),
    tableOf({ class: "even" }, [heading(map.row_descriptor + " \\ " + map.column_descriptor), map.columns.map(heading)],
            rows.reverse()),  // upwards, as in a plot
    map.left_out ? html("p", { class: "support" }, plural(map.left_out, "run") + " outside all bins or without a value") : null);
}

function mapSection(method) {
  const maps = report.maps.filter((map) => method === null || map.method === method);
  return maps.length === 0 ? null : maps.map(mapCard);
}
