// SPDX-License-Identifier: BSD-3-Clause
#include "address_text.h"
#include "history_report.h"

#include <slalom/analysis/history.h>
#include <slalom/io/result_file.h>
#include <slalom/report/figures.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

namespace fs = std::filesystem;

const Interpreter& history_interpreter() {
  const auto& all = all_interpreters();
  return *std::find_if(all.begin(), all.end(),
                       [](const Interpreter& interpreter) { return interpreter.id == "history"; });
}

std::string folder_name(const std::string& results, std::size_t index) {
  const fs::path path = fs::path(results).lexically_normal();
  const fs::path name = path.has_filename() ? path : path.parent_path();
  return std::to_string(index + 1) + "-" + name.stem().string();
}

}  // namespace

void report_history(const std::vector<std::string>& paths, const std::vector<ResultTable>& results,
                    const AnalysisRequest& request, const std::string& folder,
                    const WriteReport& write_report) {
  const Interpreter& history = history_interpreter();
  require_number_of_results(history, results.size());
  std::vector<ResultTable> shown = results;
  const AnalysisQuery query = make_query(request, history, results[0]);
  const Interpretation found = interpret(history, shown, query);

  std::vector<std::string> names, figures;
  for (const std::string& path : paths) names.push_back(folder_name(path, names.size()));
  const History curves = build_history(shown, query.metrics, query.comparison);
  for (const std::string& metric : query.metrics)
    figures.push_back(history_figure(curves, metric, names));
  for (std::size_t i = 0; i < paths.size(); ++i)
    write_report(i, (fs::path(folder) / names[i]).string());
  const auto address_of = [&](const std::string& column, const std::string& field) {
    if (column == "run") return address_text(names.back()) + "/run.html#" + address_text(field);
    if (column != "results") return std::string();
    for (std::size_t i = 0; i < results.size(); ++i)
      if (results[i].source == field) return address_text(names[i]) + "/index.html";
    return std::string();
  };
  write_file_atomically(
      (fs::path(folder) / "index.html").string(),
      render_html(found, "History of " + results.back().source, address_of, figures));
}

}  // namespace slalom
