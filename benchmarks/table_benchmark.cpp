// SPDX-License-Identifier: BSD-3-Clause
// A million runs with forty metrics: cross tables in memory, and reading from a result file
// (created once in the folder for temporary files), compared with SQLite's GROUP BY over the same
// file. Counter `peak_MB` is the peak memory of the process so far: run benchmarks one by one
// (--benchmark_filter).
#include <slalom/analysis/cross_table.h>
#include <slalom/core/random.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <benchmark/benchmark.h>

#include <filesystem>
#include <sys/resource.h>

namespace slalom {
namespace {

constexpr int kScenarios = 20000, kMethods = 10, kRepetitions = 5, kMetrics = 40;

std::string metric_id(int i) {
  return i == 0 ? "success" : "metric_" + std::to_string(i);
}

QuantityInfo metric_info(int i) {
  if (i == 0) return success_info();
  return {metric_id(i), 1, metric_id(i), "-", Direction::Up};
}

const QuantityInfo kDensity = {"density", 1, "Density", "-", Direction::None};

std::vector<std::string> all_ids() {
  std::vector<std::string> ids;
  for (int i = 0; i < kMetrics; ++i) ids.push_back(metric_id(i));
  return ids;
}

std::string hash_of(int scenario) {
  std::string digits = std::to_string(scenario);
  return std::string(32 - digits.size(), '0') + digits;
}

/// One in ten runs fails; a third of the metrics is available only for successful runs.
Value value_of(RandomEngine& engine, int metric, bool success) {
  if (metric == 0) return Value::of(success ? 1 : 0);
  if (!success && metric % 3 == 0) return Value::na("outcome: collision");
  return Value::of(uniform_real(engine, 0, 1));
}

ResultTable make_columns() {
  RandomEngine engine(1);
  ResultTable columns;
  columns.outcomes = {"success", "collision"};
  for (int m = 0; m < kMethods; ++m) columns.methods.push_back("method" + std::to_string(m));
  columns.descriptors.emplace_back(kDensity);
  for (int i = 0; i < kMetrics; ++i) {
    columns.metrics.emplace_back(metric_info(i));
    columns.metrics.back().reserve(static_cast<std::size_t>(kScenarios) * kMethods * kRepetitions);
  }
  for (int s = 0; s < kScenarios; ++s) {
    columns.scenario_hashes.push_back(hash_of(s));
    columns.scenario_names.push_back(hash_of(s));
    columns.descriptors[0].add_number(uniform_real(engine, 0, 1));
    for (int run = 0; run < kMethods * kRepetitions; ++run) {
      const bool success = uniform_real(engine, 0, 1) < 0.9;
      columns.scenario.push_back(static_cast<std::uint32_t>(s));
      columns.method.push_back(static_cast<std::uint32_t>(run / kRepetitions));
      columns.repetition.push_back(static_cast<std::uint32_t>(run % kRepetitions));
      columns.outcome.push_back(success ? 0 : 1);
      for (int i = 0; i < kMetrics; ++i) {
        columns.metrics[static_cast<std::size_t>(i)].add(value_of(engine, i, success));
      }
    }
  }
  return columns;
}

void write_file(const std::string& path) {
  RandomEngine engine(1);
  std::vector<QuantityInfo> metrics;
  for (int i = 0; i < kMetrics; ++i) metrics.push_back(metric_info(i));
  ResultFile file = ResultFile::create(path, {}, {kDensity}, metrics);
  const Scenario scenario = Scenario::continuous("s", {0, 0, 9, 9}, {}, {1, 1, 0}, {5, 5});
  for (int s = 0; s < kScenarios; ++s) {
    ScenarioRecord record{hash_of(s), hash_of(s), {}};
    record.descriptors["density"] = {1, Value::of(uniform_real(engine, 0, 1))};
    file.add_scenario(record, scenario, {});
    for (int index = 0; index < kMethods * kRepetitions; ++index) {
      const bool success = uniform_real(engine, 0, 1) < 0.9;
      RunRecord run;
      run.scenario_hash = run.scenario_name = record.hash;
      run.method = "method" + std::to_string(index / kRepetitions);
      run.repetition = index % kRepetitions;
      run.outcome = success ? "success" : "collision";
      for (int i = 0; i < kMetrics; ++i) {
        run.metrics[metric_id(i)] = {1, value_of(engine, i, success)};
      }
      file.add_run(run, {}, {});
    }
    if (s % 100 == 99) file.commit();
  }
  file.commit();
}

std::string file_of_million() {
  const std::string path = std::filesystem::temp_directory_path() / "slalom_million.results";
  if (!std::filesystem::exists(path)) {
    write_file(path + ".part");
    std::filesystem::rename(path + ".part", path);
  }
  return path;
}

void count_memory(benchmark::State& state) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

AnalysisOptions without_ids() {
  AnalysisOptions options;
  options.run_ids = options.medians = false;
  return options;
}

/// Ten bins by as many columns as the argument, for one method and for all ten.
void cross_table(benchmark::State& state, const std::string& method) {
  static const ResultTable columns = make_columns();
  std::vector<std::string> ids = all_ids();
  ids.resize(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        build_cross_tables(columns, {parse_bin_spec("density:10")}, ids, without_ids(), method));
  }
  count_memory(state);
}

void of_one_method(benchmark::State& state) {
  cross_table(state, "method3");
}

void of_all_methods(benchmark::State& state) {
  cross_table(state, "");
}

void read_some(benchmark::State& state) {
  const std::string path = file_of_million();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        read_results(path, std::vector<std::string>{"success", "metric_1", "metric_3", "density"}));
  }
  count_memory(state);
}

void read_all(benchmark::State& state) {
  const std::string path = file_of_million();
  for (auto _ : state) benchmark::DoNotOptimize(read_results(path));
  count_memory(state);
}

void group_by_in_sql(benchmark::State& state) {
  SQLite::Database database(file_of_million(), SQLite::OPEN_READONLY);
  std::string sql = "SELECT method, CAST(value * 10 AS INTEGER) AS bin, count(*)";
  for (const std::string& id : all_ids()) sql += ", avg(m_" + id + ")";
  sql += " FROM runs JOIN descriptors ON hash = scenario GROUP BY method, bin";
  for (auto _ : state) {
    SQLite::Statement rows(database, sql);
    while (rows.executeStep()) benchmark::DoNotOptimize(rows.getColumn(3).getDouble());
  }
  count_memory(state);
}

BENCHMARK(of_one_method)->Arg(3)->Arg(kMetrics)->Unit(benchmark::kMillisecond);
BENCHMARK(of_all_methods)->Arg(3)->Arg(kMetrics)->Unit(benchmark::kMillisecond);
BENCHMARK(read_some)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(read_all)->Unit(benchmark::kMillisecond)->Iterations(2);
BENCHMARK(group_by_in_sql)->Unit(benchmark::kMillisecond)->Iterations(2);

}  // namespace
}  // namespace slalom
