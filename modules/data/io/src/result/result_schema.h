// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "database.h"

#include <slalom/core/value.h>

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Result files: versions, and all tables but `runs`, whose columns depend on the metrics, and
/// `run_outputs`.
extern const DatabaseKind kResultFile;

/// The table of what methods printed, in files with such text only.
constexpr const char* kCreateRunOutputs =
    "CREATE TABLE IF NOT EXISTS run_outputs (run INTEGER PRIMARY KEY, content BLOB NOT NULL, "
    "checksum INTEGER NOT NULL)";

/// The columns of a run in the order of select_runs(): those of the metrics follow, then the
/// checksum of all but the first.
struct RunColumn {
  enum : int {
    Run,
    Scenario,
    ScenarioName,
    Method,
    Repetition,
    Seed,
    Outcome,
    OutcomeDetail,
    TrajectoryHash,
    Reasons,         ///< why metrics are NA, JSON by id
    StandardErrors,  ///< of metrics, JSON by id
    FirstMetric
  };
};
std::string create_runs(const std::vector<QuantityInfo>& metrics);
/// The columns between the first and the checksum, "scenario, ..., m_spl".
std::string run_columns(const std::vector<QuantityInfo>& metrics);
std::string select_runs(const std::vector<QuantityInfo>& metrics, const std::string& rest = "");

/// The descriptors of a scenario in the order in which its checksum contains all their columns.
constexpr const char* kSelectDescriptors =
    "SELECT id, version, value, standard_error, reason FROM descriptors WHERE hash = ? ORDER BY id";

/// The columns of `quantities` in a file of its version, without the position: those up to the
/// direction, then kind and range of the values unless the version has none.
std::string quantity_columns(SQLite::Database& database);
bool states_ranges(SQLite::Database& database);
/// Kind and range in the files that do not state them.
std::pair<std::string, std::string> unstated_range(const std::string& id);

/// Checksum of the manifest and the quantities, which the table `header` contains.
std::int64_t header_checksum(SQLite::Database& database);

/// Parses a JSON object in a column; does not trust its contents. Throws Error (File).
nlohmann::json object_in(const std::string& text, const std::string& path);
/// Why a metric is NA, by the object of the column.
std::string reason_in(const nlohmann::json& reasons, const std::string& id);

}  // namespace slalom
