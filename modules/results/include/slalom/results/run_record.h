#pragma once

#include <slalom/core/value.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// A value with the version of the formula that made it.
struct VersionedValue {
  int version = 1;
  Value value = Value::na("not computed");
};

/// One run: everything deterministic that is known of it, by names; nothing about robots here.
struct RunRecord {
  std::string scenario_hash, scenario_name;
  std::string method;
  int repetition = 0;
  std::uint64_t seed = 0;
  std::string outcome;  ///< e.g. "success"
  std::string outcome_detail;
  std::string trajectory_hash;
  std::map<std::string, VersionedValue> metrics;  ///< by id
};

/// Wall-clock figures of a run, kept apart from the rest (s).
struct RunTiming {
  double wall_seconds = 0;
  std::map<std::string, double> values;  ///< "cycle_time_mean", ..., in timing_unit()
};

/// The unit of a wall-clock figure: "-" of ratios, else "ms".
std::string timing_unit(const std::string& id);

/// What is known of a scenario.
struct ScenarioRecord {
  std::string hash, name;
  std::map<std::string, VersionedValue> descriptors;  ///< by id
};

/// Everything needed to repeat a campaign, as text by key (campaign .ini, seeds, versions, hashes).
using Manifest = std::map<std::string, std::string>;

/// What an analysis works on: the runs of one result file with their scenarios and quantities.
struct ResultTable {
  Manifest manifest;
  std::map<std::string, QuantityInfo> quantities;   ///< of every metric and descriptor, by id
  std::map<std::string, ScenarioRecord> scenarios;  ///< by hash
  std::vector<RunRecord> runs;     ///< ordered by scenario name, hash, method, repetition
  std::vector<RunTiming> timings;  ///< parallel to runs
};

/// Puts the runs (and timings with them) into their one order.
void sort_runs(ResultTable& table);

/// "hash8/method/repetition": how people and links name a run.
std::string run_id(const RunRecord& run);

}  // namespace slalom
