#include "html_text.h"
#include "report_scripts.h"
#include "run_data.h"
#include "run_pages.h"

#include <slalom/core/error.h>

#include <filesystem>

namespace slalom {
namespace {

constexpr const char* kRunBody = R"html(<header><h1 id="title">Run</h1>
<p><a href="index.html">Report</a> · <a href="runs.html">All runs</a> · <a id="scenario" href="index.html">This scenario</a></p>
<p id="problem" role="alert" hidden></p><noscript><p>This page needs scripts; they come with the report.</p></noscript></header>
<main id="viewer" hidden>
<p class="soft">Outcome: <b id="outcome"></b> · run <code id="id"></code> · seed <code id="seed"></code>
<span id="rawlog" hidden> · <a>rawlog</a>, see <code>slalom-replay play</code></span></p>
<div class="run"><div>
<div class="picture"><svg id="scene" role="img" aria-label="The place and the way of the robot"></svg></div>
<p class="controls"><button id="play">Play</button>
<label>Pace <select id="pace"><option>0.5</option><option selected>1</option><option>2</option><option>4</option><option>8</option></select></label>
<input id="time" type="range" min="0" value="0" step="0.01" aria-label="Time in seconds">
<label><input id="scan" type="checkbox" checked> scan</label>
<label><input id="others" type="checkbox"> other runs here</label></p>
<p id="moment" class="soft" aria-live="off"></p>
<svg id="clearance" class="plot" role="img"></svg>
<svg id="speed" class="plot" role="img"></svg>
<p class="soft">The scan is that of an ideal sensor at the pose shown. Between the moments kept, poses are
interpolated; the rawlog has all of them.</p>
</div><div>
<h2>Runs in this scenario</h2><ul id="runs" class="plain"></ul>
<h2>Values</h2><table class="values"><tbody id="values"></tbody></table>
</div></div></main>
<script>let metrics = [];
function slalomMetrics(data) { metrics = data; }</script>
<script src="data/metrics.js"></script><script src="run.js"></script>
)html";

constexpr const char* kRunsBody = R"html(<header><h1 id="title">Runs</h1>
<p><a href="index.html">Report</a> · <a href="runs.html">All runs</a></p>
<noscript><p>This page needs scripts; they come with the report.</p></noscript></header>
<main><p class="controls"><label>Filter <input id="filter" type="search" placeholder="scenario, method, outcome"></label>
<span id="count" class="soft" role="status"></span></p>
<div class="card"><table class="sortable"><thead><tr id="header"></tr></thead><tbody id="rows"></tbody></table></div></main>
<script src="runs.js"></script><script src="data/runs.js"></script><script src="data/cells.js"></script>
)html";

}  // namespace

std::map<std::string, std::vector<std::size_t>> runs_by_scenario(const ResultTable& table) {
  std::map<std::string, std::vector<std::size_t>> runs;
  for (std::size_t i = 0; i < table.runs.size(); ++i)
    runs[table.runs[i].scenario_hash].push_back(i);
  return runs;
}

std::string run_link(const RunRecord& run) {
  return "run.html#" + url_path(run_id(run));
}

void write_run_pages(const RunPages& pages, const std::string& directory) {
  const std::filesystem::path folder(directory), data = folder / "data";
  std::error_code problem;
  std::filesystem::create_directories(data, problem);
  if (problem) throw job_error(data.string(), "cannot be made: " + problem.message(), "a folder");
  const RunNames names = {metric_ids(pages.table), method_names(pages.table)};
  for (const auto& [hash, runs] : runs_by_scenario(pages.table)) {
    const auto scenario = pages.table.scenarios.find(hash);
    if (scenario == pages.table.scenarios.end()) continue;
    write_file_atomically((data / ("s-" + hash.substr(0, 8) + ".js")).string(),
                          scenario_script(pages, names, scenario->second, runs, directory));
  }
  write_file_atomically((data / "metrics.js").string(), metrics_script(pages));
  write_file_atomically((data / "runs.js").string(), runs_script(pages));
  write_file_atomically((data / "cells.js").string(), cells_script(pages));
  write_file_atomically((folder / "run.js").string(), kRunScript);
  write_file_atomically((folder / "runs.js").string(), kRunsScript);
  write_file_atomically((folder / "run.html").string(), html_page("Run - Slalom", kRunBody));
  write_file_atomically((folder / "runs.html").string(), html_page("Runs - Slalom", kRunsBody));
}

}  // namespace slalom
