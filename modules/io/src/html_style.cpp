#include "html_style.h"

namespace slalom {

const char* const kReportStyle = R"css(
:root { color-scheme: light dark; --ground: #f6f7f9; --card: #ffffff; --ink: #1b2430; --soft: #5b6776;
  --line: #dfe4ea; --accent: #0b5fa5; --heat: 0 128 96; --good: #14804a; --hit: #c5291f; --late: #b06f00;
  --fault: #7a3fb0; --odd: #667085; }
@media (prefers-color-scheme: dark) { :root { --ground: #12161c; --card: #1b212a; --ink: #e7ecf2;
  --soft: #9aa7b6; --line: #303945; --accent: #6cb6ff; --heat: 38 166 128; --good: #3fb96f; --hit: #f0665c;
  --late: #e0a33a; --fault: #b98af0; --odd: #98a2b3; } }
* { box-sizing: border-box; }
html { scroll-behavior: smooth; scroll-padding-top: 3.5rem; }
body { margin: 0; background: var(--ground); color: var(--ink);
  font: 15px/1.5 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
header, main, footer { max-width: 1280px; margin: 0 auto; padding: 0 1.5rem; }
header { padding-top: 2.2rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0; letter-spacing: -0.01em; }
h2 { font-size: 1.3rem; margin: 2.6rem 0 0.8rem; }
h3 { font-size: 1.05rem; margin: 1.8rem 0 0.6rem; }
h4 { font-size: 0.95rem; margin: 0 0 0.6rem; overflow-wrap: anywhere; }
a { color: var(--accent); text-decoration: none; } a:hover { text-decoration: underline; }
p { margin: 0.4rem 0; max-width: 78ch; } .soft { color: var(--soft); }
nav { position: sticky; top: 0; z-index: 2; background: var(--ground); border-bottom: 1px solid var(--line);
  margin-top: 1rem; }
nav div { max-width: 1280px; margin: 0 auto; padding: 0.6rem 1.5rem; display: flex; gap: 1.4rem;
  flex-wrap: wrap; }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(130px, 1fr)); gap: 0.8rem;
  margin: 1.4rem 0 0; }
.facts div { background: var(--card); border: 1px solid var(--line); border-radius: 10px;
  padding: 0.7rem 1rem; }
.facts b { display: block; font-size: 1.35rem; font-weight: 650; font-variant-numeric: tabular-nums; }
.facts span { color: var(--soft); font-size: 0.85rem; }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 1rem 1.1rem;
  margin: 0 0 1rem; overflow-x: auto; }
table { border-collapse: separate; border-spacing: 0; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: 0.5rem 0.7rem;
  border-bottom: 1px solid var(--line); }
tr:last-child > th, tr:last-child > td { border-bottom: 0; }
thead th { font-size: 0.82rem; color: var(--soft); font-weight: 600; vertical-align: bottom;
  border-bottom: 2px solid var(--line); }
tbody th { font-weight: 600; min-width: 8.5rem; }
.name { white-space: nowrap; }
table.even { table-layout: fixed; } table.even thead th { overflow-wrap: anywhere; }
td.cell { background: rgb(var(--heat) / calc(var(--g, 0) * 0.42)); min-width: 7.4rem; }
.big { font-size: 1.12rem; font-weight: 650; } .interval { font-size: 0.84rem; white-space: nowrap; display: block; }
.support { color: var(--soft); font-size: 0.78rem; display: block; }
.cell .support { white-space: nowrap; }
.whisker { display: block; width: 100%; max-width: 150px; height: 9px; margin: 0.25rem 0; }
.whisker line { stroke: currentColor; stroke-width: 1.6; opacity: 0.55; }
.whisker .axis { stroke-width: 1; opacity: 0.16; } .whisker circle { fill: currentColor; }
.na { color: var(--soft); }
.swatch { display: inline-block; width: 0.8em; height: 0.8em; border-radius: 3px; margin-right: 0.45em;
  vertical-align: -0.05em; }
.bar { display: flex; height: 12px; border-radius: 6px; overflow: hidden; gap: 1px; min-width: 9rem;
  margin: 0.35rem 0; }
.bar i { display: block; }
.bar .good { background: var(--good); } .bar .hit { background: var(--hit); }
.bar .late { background: var(--late); } .bar .fault { background: var(--fault); }
.bar .odd { background: var(--odd); }
.chip { display: inline-block; font-size: 0.78rem; white-space: nowrap; border: 1px solid currentColor;
  border-radius: 99px; padding: 0 0.5em; margin: 0 0.25em 0.15em 0; }
.chip.good { color: var(--good); } .chip.hit { color: var(--hit); } .chip.late { color: var(--late); }
.chip.fault { color: var(--fault); } .chip.odd { color: var(--odd); }
.finding { border-left: 3px solid var(--line); padding: 0.1rem 0 0.1rem 0.8rem; margin: 0.45rem 0;
  max-width: none; }
.finding.shown { border-color: var(--accent); }
ul.plain { list-style: none; padding: 0; margin: 0; }
.legend { display: flex; flex-wrap: wrap; gap: 0.3rem 1.2rem; margin: 0.4rem 0 1rem; align-items: center; }
.legend svg { vertical-align: middle; margin-right: 0.4em; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(320px, 1fr)); gap: 1rem; }
.gallery figure { margin: 0; background: var(--card); border: 1px solid var(--line); border-radius: 10px;
  padding: 0.9rem; break-inside: avoid; }
.gallery figure:target { outline: 3px solid var(--accent); }
.picture { background: #ffffff; border-radius: 6px; display: flex; justify-content: center; }
.picture svg { width: 100%; height: auto; max-height: 380px; display: block; border-radius: 6px; }
figcaption { font-size: 0.83rem; margin-top: 0.6rem; }
figcaption table { font-size: 0.83rem; } figcaption th, figcaption td { padding: 0.16rem 0.3rem; }
figcaption tbody th { font-weight: 400; min-width: 0; }
figcaption .swatch { margin-right: 0.3em; }
dl.values { display: grid; grid-template-columns: auto auto; justify-content: start; gap: 0 0.8rem;
  margin: 0.5rem 0 0; }
dl.values dt { color: var(--soft); } dl.values dd { margin: 0; font-variant-numeric: tabular-nums; }
.run { display: grid; grid-template-columns: minmax(0, 3fr) minmax(260px, 2fr); gap: 1.6rem; }
@media (max-width: 860px) { .run { grid-template-columns: 1fr; } }
.run .picture svg { max-height: 70vh; }
.run h2 { margin: 0 0 0.5rem; font-size: 1.05rem; } .run ul + h2 { margin-top: 1.4rem; }
.controls { display: flex; flex-wrap: wrap; gap: 0.5rem 1rem; align-items: center; max-width: none; }
.controls input[type=range] { flex: 1; min-width: 9rem; } .controls input[type=search] { width: 18rem; }
button, select, input[type=search] { font: inherit; color: inherit; background: var(--card);
  border: 1px solid var(--line); border-radius: 7px; padding: 0.2rem 0.7rem; }
button { cursor: pointer; } .sortable button { border: 0; padding: 0; background: none; font-weight: 600; }
.plot { width: 100%; height: auto; display: block; margin: 0.5rem 0; }
.chart { width: 100%; max-width: 820px; height: auto; display: block; }
.chart text { font-size: 12px; fill: var(--soft); } .chart .rule { stroke: var(--line); }
.chart .axis { stroke: var(--soft); } .chart .bar { stroke: var(--ink); stroke-width: 4; stroke-linecap: round; }
.plot text { font-size: 11px; fill: var(--soft); } .plot .rule { stroke: var(--line); }
.plot .cursor { stroke: var(--ink); stroke-width: 1; }
table.values { font-size: 0.83rem; } table.values th, table.values td { padding: 0.16rem 0.4rem; }
table.values th { font-weight: 400; font-family: ui-monospace, "DejaVu Sans Mono", monospace; }
[aria-current] { font-weight: 650; } [role=alert] { color: var(--hit); font-weight: 600; }
a.big { color: inherit; }
details summary { cursor: pointer; color: var(--soft); font-size: 0.82rem; font-weight: 400; }
details.runs ul { max-height: 14rem; overflow: auto; font-size: 0.8rem; font-weight: 400; padding: 0.3rem 0; }
details.runs li { white-space: nowrap; }
pre { background: var(--ground); border: 1px solid var(--line); border-radius: 8px; padding: 0.8rem;
  overflow: auto; font-size: 0.82rem; margin: 0.4rem 0; white-space: pre-wrap; overflow-wrap: anywhere; }
code { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: 0.9em; }
footer { color: var(--soft); font-size: 0.82rem; padding-top: 2rem; padding-bottom: 2.5rem; }
@media print { nav { display: none; } body { font-size: 11px; background: #fff; }
  .card, .gallery figure { border-color: #ccc; } .gallery { grid-template-columns: repeat(3, 1fr); }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
)css";

}  // namespace slalom
