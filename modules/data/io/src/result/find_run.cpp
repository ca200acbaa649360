// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/find_run.h>
#include <slalom/io/read_results.h>

#include <optional>
#include <vector>

namespace slalom {
namespace {

/// The parts of SCENARIO/METHOD/REPETITION; the name of a scenario may contain slashes.
struct RunName {
  std::string scenario, rest;  ///< rest: "/METHOD/REPETITION"

  explicit RunName(const std::string& id) : scenario(id) {
    std::size_t slash = id.rfind('/');
    if (slash != std::string::npos && slash > 0) slash = id.rfind('/', slash - 1);
    if (slash == std::string::npos) return;
    scenario = id.substr(0, slash);
    rest = id.substr(slash);
  }

  /// Compares its name, or at least eight digits of its hash.
  bool is_scenario(const std::string& hash, const std::string& name) const {
    return scenario == name || (scenario.size() >= 8 && starts_with(hash, scenario));
  }
};

/// "/METHOD/REPETITION" of a run.
std::string rest_of(const ResultTable& runs, std::size_t run) {
  const std::size_t digits = runs.scenario_hashes[runs.scenario[run]].substr(0, 8).size();
  return run_id(runs, run).substr(digits);
}

/// Suggests another run of the scenario, or of one with a similar name. Hashes are not compared:
/// similar ones have nothing in common.
std::string suggestion(const ResultTable& runs, const RunName& wanted) {
  std::vector<std::string> of_scenario, names;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const std::size_t scenario = runs.scenario[run];
    const std::string& name = runs.scenario_names[scenario];
    const std::string rest = rest_of(runs, run);
    if (wanted.is_scenario(runs.scenario_hashes[scenario], name))
      of_scenario.push_back(wanted.scenario + rest);
    if (rest == wanted.rest) names.push_back(name + rest);
  }
  if (of_scenario.empty()) return nearest_name(wanted.scenario + wanted.rest, names);
  const std::string nearest = nearest_name(wanted.scenario + wanted.rest, of_scenario);
  return nearest.empty() ? of_scenario.front() : nearest;
}

}  // namespace

RunRecord find_run(const ResultFile& file, const std::string& id) {
  const ResultTable runs = read_results(file.path(), std::vector<std::string>{});
  const RunName wanted(id);
  std::optional<std::size_t> found;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const std::size_t scenario = runs.scenario[run];
    if (!wanted.is_scenario(runs.scenario_hashes[scenario], runs.scenario_names[scenario]) ||
        rest_of(runs, run) != wanted.rest)
      continue;
    if (found)
      throw usage_error("run '" + id + "'", "ambiguous",
                        "the hash of the scenario, or more digits of it");
    found = run;
  }
  const std::string short_id = wanted.scenario.substr(0, 8) + wanted.rest;
  if (!found && contains(runs.damaged, "run " + short_id))
    throw file_error(file.path() + ": run " + short_id, "is damaged (does not match its checksum)",
                     "an unmodified file");
  if (!found) {
    const std::string meant = suggestion(runs, wanted);
    std::string expected = "SCENARIO/METHOD/REPETITION with the name or the hash of a scenario";
    if (!meant.empty()) expected += ", perhaps " + meant;
    throw usage_error("run '" + id + "'", "no such run in these results", expected);
  }
  const auto run =
      file.read_run(runs.scenario_hashes[runs.scenario[*found]], runs.methods[runs.method[*found]],
                    static_cast<int>(runs.repetition[*found]));
  if (!run) throw file_error(file.path() + ": run " + id, "is damaged (missing in the index)");
  return *run;
}

}  // namespace slalom
