// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Reasons of missing values: of what a file does not contain, and of what was not enabled.
constexpr const char* kNotRecorded = "not recorded";
constexpr const char* kNotComputed = "not computed";

/// A value with the version of its formula.
struct VersionedValue {
  int version = 1;
  Value value = Value::na(kNotComputed);
};

/// The value, or NA ("other version 1") if its version is not this one.
Value value_of_version(const VersionedValue& versioned, int version);

/// The deterministic results of one run, as names and values; independent of robotics types.
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

/// Wall-clock figures of a run (s), separate from the deterministic results, and what else of it
/// cannot be repeated.
struct RunTiming {
  double wall_seconds = 0;
  std::map<std::string, double> values = {};  ///< "cycle_time_mean", ..., by timing_info()
  std::string output = {};                    ///< printed by the method, bounded
};

/// A wall-clock figure: a fraction if it is called "..._ratio", a number of commands if
/// "commands_...", else a time in ms.
QuantityInfo timing_info(const std::string& id);

/// The metric that every run has by its outcome.
QuantityInfo success_info();

/// The recorded data of a scenario.
struct ScenarioRecord {
  std::string hash, name;
  std::map<std::string, VersionedValue> descriptors;  ///< by id
};

/// Everything needed to repeat a campaign, as text by key (campaign .ini, seeds, versions, hashes).
using Manifest = std::map<std::string, std::string>;

/// "hash8/method/repetition": the id of a run in commands and links.
std::string run_id(const RunRecord& run);

}  // namespace slalom
