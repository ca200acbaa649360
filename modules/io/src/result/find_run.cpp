#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/find_run.h>
#include <slalom/io/read_results.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace slalom {
namespace {

/// Whether `id` is "HASH.../METHOD/REPETITION" of this run, with at least eight digits of the hash.
bool matches(const std::string& id, const ResultTable& runs, std::size_t run) {
  const std::size_t slash = id.find('/');
  if (slash == std::string::npos || slash < 8) return false;
  return runs.scenario_hashes[runs.scenario[run]].compare(0, slash, id, 0, slash) == 0 &&
         id.substr(slash) == run_id(runs, run).substr(8);
}

}  // namespace

RunRecord find_run(const ResultFile& file, const std::string& id) {
  const ResultTable runs = read_results(file.path(), std::vector<std::string>{});
  std::optional<std::size_t> found;
  std::vector<std::string> ids;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    ids.push_back(run_id(runs, run));
    if (!matches(id, runs, run)) continue;
    if (found) throw usage_error("run '" + id + "'", "ambiguous", "more digits of the hash");
    found = run;
  }
  const std::size_t slash = std::min(id.find('/'), id.size());
  const std::string short_id = id.substr(0, std::min<std::size_t>(slash, 8)) + id.substr(slash);
  if (!found && contains(runs.damaged, "run " + short_id))
    throw file_error(file.path() + ": run " + short_id, "is damaged (does not match its checksum)",
                     "a file as it was written");
  if (!found) {
    const std::string nearest = nearest_name(id, ids);
    std::string expected = "HASH8/METHOD/REPETITION as in dumps and reports";
    if (!nearest.empty()) expected += ", perhaps " + nearest;
    throw usage_error("run '" + id + "'", "no such run in these results", expected);
  }
  const auto run =
      file.read_run(runs.scenario_hashes[runs.scenario[*found]], runs.methods[runs.method[*found]],
                    static_cast<int>(runs.repetition[*found]));
  if (!run) throw file_error(file.path() + ": run " + id, "is damaged (missing in the index)");
  return *run;
}

}  // namespace slalom
