// SPDX-License-Identifier: BSD-3-Clause
#include "checked_row.h"
#include "result_schema.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/results/run_record.h>

#include <iomanip>
#include <sstream>

namespace slalom {
namespace {

constexpr int kOldestVersion = 3, kVersionOfRanges = 4;

struct Column {
  const char *name, *type;
};
constexpr Column kRunColumns[RunColumn::FirstMetric] = {
    {"run", "INTEGER PRIMARY KEY"},       {"scenario", "TEXT NOT NULL"},
    {"scenario_name", "TEXT NOT NULL"},   {"method", "TEXT NOT NULL"},
    {"repetition", "INTEGER NOT NULL"},   {"seed", "TEXT NOT NULL"},
    {"outcome", "TEXT NOT NULL"},         {"outcome_detail", "TEXT NOT NULL"},
    {"trajectory_hash", "TEXT NOT NULL"}, {"reasons", "TEXT NOT NULL"},
    {"standard_errors", "TEXT NOT NULL"},
};

/// The kinds and ranges of values that files of version 3 do not state, by id. All other quantities
/// there are amounts without a range.
struct KnownRange {
  const char *kind, *range, *ids;
};
constexpr KnownRange kRangesOfVersion3[] = {
    {"rate", "0..1", "success mover_collision stood_at_contact"},
    {"count", "0..", "oscillation_count contact_mover obstacle_count"},
    {"ratio", "..", "log_dimensionless_jerk"},
    {"ratio", "..-1", "sparc"},
    {"ratio", "..1", "progress"},
    {"ratio", "0..",
     "safety path_excess time_ratio clustering traversability dynamic_density "
     "dynamic_traversability"},
    {"ratio", "0..0.5", "barn_score_v2"},
    {"ratio", "0..1",
     "optimality optisafe spl soft_spl risk_time_ratio density cspace_density clearness "
     "confinement confinement_path narrow_fraction trap_fraction goal_visibility"},
    {"ratio", "0..16", "barn_dispersion"},
    {"ratio", "1..", "arrival_ratio detour_ratio barn_tortuosity"},
    {"amount", "0..",
     "optimality_area safety_area path_length time_to_goal par2_time impact_speed "
     "min_time_to_collision final_distance closest_distance mean_speed time_stopped "
     "cumulative_heading_change angle_over_length bending_energy max_curvature path_irregularity "
     "rms_linear_acceleration rms_angular_acceleration rms_linear_jerk rms_angular_jerk "
     "command_variation_v command_variation_w frechet_to_reference hausdorff_to_reference "
     "mover_contact_speed mover_time_to_collision personal_space_time intimate_space_time "
     "frozen_time clearness_mean_distance bottleneck_width clearance_mean clearance_q05 "
     "turn_density barn_closest_distance barn_visibility barn_characteristic_dimension "
     "crossing_flow"},
    {"amount", "0..1", "occupancy_entropy"},
    {"amount", "0..1.2", "personal_space_depth"},
    {"amount", "0..12", "survivability"},
    {"amount", "0..100", "inverse_clearance"},
};

/// The column of a metric: ids of foreign tables may contain anything, and SQLite does not
/// distinguish upper and lower case.
std::string column_of(const QuantityInfo& info) {
  std::ostringstream column;
  column << std::hex << std::setfill('0');
  for (const char c : info.id) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    if (plain)
      column << c;
    else
      column << '%' << std::setw(2) << int{static_cast<unsigned char>(c)};
  }
  return "\"m_" + column.str() + "\"";
}

}  // namespace

const DatabaseKind kResultFile = {"a result file (.results)", 0x534c5253 /* "SLRS" */,
                                  kVersionOfRanges, R"(
CREATE TABLE manifest (key TEXT PRIMARY KEY, text TEXT NOT NULL);
CREATE TABLE quantities (position INTEGER PRIMARY KEY, kind TEXT NOT NULL, id TEXT NOT NULL,
                         version INTEGER NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL,
                         direction TEXT NOT NULL, value_kind TEXT NOT NULL,
                         value_range TEXT NOT NULL, UNIQUE (kind, id));
CREATE TABLE header (checksum INTEGER NOT NULL);
CREATE TABLE scenarios (hash TEXT PRIMARY KEY, name TEXT NOT NULL, checksum INTEGER NOT NULL,
                        content_checksum INTEGER NOT NULL, refs_checksum INTEGER NOT NULL,
                        content BLOB NOT NULL, refs BLOB NOT NULL);
CREATE TABLE descriptors (hash TEXT NOT NULL, id TEXT NOT NULL, version INTEGER NOT NULL,
                          value REAL, standard_error REAL, reason TEXT,
                          PRIMARY KEY (hash, id)) WITHOUT ROWID;
CREATE TABLE trajectories (run INTEGER PRIMARY KEY, content BLOB NOT NULL,
                           checksum INTEGER NOT NULL);
CREATE TABLE reference_timings (hash TEXT PRIMARY KEY, exact_seconds REAL NOT NULL,
                                planner_seconds REAL NOT NULL, safest_seconds REAL NOT NULL,
                                checksum INTEGER NOT NULL);
CREATE TABLE run_timings (run INTEGER PRIMARY KEY, wall_seconds REAL NOT NULL, figures TEXT NOT NULL,
                          checksum INTEGER NOT NULL);
)",
                                  kOldestVersion};

std::string create_runs(const std::vector<QuantityInfo>& metrics) {
  std::string sql = "CREATE TABLE runs (";
  for (const Column& column : kRunColumns)
    sql += std::string(column.name) + " " + column.type + ", ";
  for (const QuantityInfo& info : metrics) sql += column_of(info) + " REAL, ";
  return sql + "checksum INTEGER NOT NULL, UNIQUE (scenario, method, repetition))";
}

std::string run_columns(const std::vector<QuantityInfo>& metrics) {
  std::vector<std::string> names;
  for (const Column& column : kRunColumns) names.emplace_back(column.name);
  for (const QuantityInfo& info : metrics) names.push_back(column_of(info));
  return join({names.begin() + 1, names.end()}, ", ");
}

std::string select_runs(const std::vector<QuantityInfo>& metrics, const std::string& rest) {
  return "SELECT run, " + run_columns(metrics) + ", checksum FROM runs " + rest;
}

bool states_ranges(SQLite::Database& database) {
  return database.execAndGet("PRAGMA user_version").getInt() >= kVersionOfRanges;
}

std::string quantity_columns(SQLite::Database& database) {
  return std::string("kind, id, version, name, unit, direction") +
         (states_ranges(database) ? ", value_kind, value_range" : "");
}

std::pair<std::string, std::string> unstated_range(const std::string& id) {
  for (const KnownRange& known : kRangesOfVersion3)
    if (contains(split_nonempty(known.ids, ' '), id)) return {known.kind, known.range};
  return {"amount", ".."};
}

std::int64_t header_checksum(SQLite::Database& database) {
  RowChecksum checksum;
  for (const std::string& sql :
       {std::string("SELECT key, text FROM manifest ORDER BY key"),
        "SELECT " + quantity_columns(database) + " FROM quantities ORDER BY position"}) {
    SQLite::Statement rows(database, sql);
    while (rows.executeStep()) checksum.add_columns(rows, 0, rows.getColumnCount());
  }
  return checksum.value();
}

nlohmann::json object_in(const std::string& text, const std::string& path) {
  nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) throw file_error(path, "contains a damaged row", "a JSON object");
  return json;
}

std::string reason_in(const nlohmann::json& reasons, const std::string& id) {
  const auto found = reasons.find(id);
  const bool known = found != reasons.end() && found->is_string();
  return known ? found->get<std::string>() : kNotRecorded;
}

}  // namespace slalom
