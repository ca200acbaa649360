#include <slalom/results/run_record.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace slalom {
namespace {

/// `values` in the order of `indexes`.
template <typename T>
std::vector<T> reordered(std::vector<T>& values, const std::vector<std::size_t>& indexes) {
  std::vector<T> result;
  result.reserve(values.size());
  for (const std::size_t i : indexes) result.push_back(std::move(values[i]));
  return result;
}

}  // namespace

std::string timing_unit(const std::string& id) {
  const std::string ratio = "_ratio";
  const bool is_ratio =
      id.size() > ratio.size() && id.compare(id.size() - ratio.size(), ratio.size(), ratio) == 0;
  return is_ratio ? "-" : "ms";
}

void sort_runs(ResultTable& table) {
  std::vector<std::size_t> order(table.runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&table](std::size_t i) {
    const RunRecord& run = table.runs[i];
    return std::tie(run.scenario_name, run.scenario_hash, run.method, run.repetition);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  table.timings.resize(table.runs.size());
  table.runs = reordered(table.runs, order);
  table.timings = reordered(table.timings, order);
}

std::string run_id(const RunRecord& run) {
  return run.scenario_hash.substr(0, 8) + "/" + run.method + "/" + std::to_string(run.repetition);
}

}  // namespace slalom
