#include "show.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>

#include <vector>

namespace slalom {
namespace {

std::string line(const std::string& name, const std::string& value) {
  return pad_right(printable(name), 28) + "  " + printable(value) + "\n";
}

std::string value_text(const Value& value) {
  if (value.is_na()) return "NA (" + value.reason() + ")";
  const std::string number = format_number(value.number());
  if (!value.standard_error()) return number;
  return number + " (standard error " + format_number(*value.standard_error()) + ")";
}

std::string quantities_text(const ResultTable& table,
                            const std::map<std::string, VersionedValue>& values) {
  std::string text;
  for (const auto& [id, value] : values) {
    const auto info = table.quantities.find(id);
    const bool has_unit = info != table.quantities.end() && info->second.unit != "-";
    const std::string unit = has_unit && !value.value.is_na() ? " " + info->second.unit : "";
    text += line("  " + id + " v" + std::to_string(value.version), value_text(value.value) + unit);
  }
  return text;
}

std::string timing_text(const RunTiming& timing) {
  std::string text = line("  wall_time", format_number(timing.wall_seconds) + " s");
  for (const auto& [id, value] : timing.values) {
    const std::string unit = timing_unit(id) == "-" ? "" : " " + timing_unit(id);
    text += line("  " + id, format_number(value) + unit);
  }
  return text;
}

/// "HASH.../METHOD/REPETITION" with at least the eight digits of a run id.
bool names(const std::string& id, const RunRecord& run) {
  const std::size_t slash = id.find('/');
  if (slash == std::string::npos || slash < 8) return false;
  return run.scenario_hash.compare(0, slash, id, 0, slash) == 0 &&
         id.substr(slash + 1) == run.method + "/" + std::to_string(run.repetition);
}

}  // namespace

const RunRecord& find_run(const ResultTable& table, const std::string& id) {
  const RunRecord* found = nullptr;
  std::vector<std::string> ids;
  for (const RunRecord& run : table.runs) {
    ids.push_back(run_id(run));
    if (!names(id, run)) continue;
    if (found != nullptr) {
      throw usage_error("run '" + id + "'", "names several runs", "more digits of the hash");
    }
    found = &run;
  }
  if (found != nullptr) return *found;
  const std::string nearest = nearest_name(id, ids);
  std::string expected = "HASH8/METHOD/REPETITION as dump and reports name runs";
  if (!nearest.empty()) expected += ", perhaps " + nearest;
  throw usage_error("run '" + id + "'", "not in these results", expected);
}

std::string run_text(const ResultTable& table, const RunRecord& run) {
  std::string text = line("run", run_id(run)) +
                     line("scenario", run.scenario_name + " (" + run.scenario_hash + ")") +
                     line("method", run.method) +
                     line("repetition", std::to_string(run.repetition)) +
                     line("seed", std::to_string(run.seed)) + line("outcome", run.outcome);
  if (!run.outcome_detail.empty()) text += line("detail", run.outcome_detail);
  text += line("trajectory", run.trajectory_hash);
  text += "metrics\n" + quantities_text(table, run.metrics);
  const auto scenario = table.scenarios.find(run.scenario_hash);
  if (scenario != table.scenarios.end()) {
    text += "descriptors of the scenario\n" + quantities_text(table, scenario->second.descriptors);
  }
  const auto place = static_cast<std::size_t>(&run - table.runs.data());
  if (place < table.timings.size()) {
    text += "wall clock (differs from run to run)\n" + timing_text(table.timings[place]);
  }
  return text;
}

}  // namespace slalom
