// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/packed_scenario.h>
#include <slalom/io/packed_trajectory.h>
#include <slalom/references/reference.h>
#include <slalom/results/run_record.h>
#include <slalom/scenario/scenario.h>
#include <slalom/trajectory/trajectory.h>

#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Called with what is damaged ("run 0123abcd/nd/0") and therefore skipped.
using DamageHandler = std::function<void(const std::string& what)>;

/// A result file (.results): one SQLite file with manifest, quantities, scenarios (content,
/// descriptors, references), runs (one row each, one column per metric, NA reasons), trajectories
/// (compressed). Wall-clock timings are in separate tables. Each row has a checksum: what is
/// damaged is not returned. Errors are Error (File).
class ResultFile {
 public:
  /// Creates a file at `path` with the given quantities, replacing an existing result file. Throws
  /// Error (Job) when it cannot be written, Error (File) when there is a file of another kind.
  static ResultFile create(const std::string& path, const Manifest& manifest,
                           const std::vector<QuantityInfo>& descriptors,
                           const std::vector<QuantityInfo>& metrics);
  static ResultFile open(const std::string& path);
  /// Whether there is a file with content at `path`.
  static bool exists(const std::string& path);
  ~ResultFile();
  ResultFile(ResultFile&&) noexcept;
  ResultFile& operator=(ResultFile&&) noexcept;

  const std::string& path() const;
  const std::vector<QuantityInfo>& descriptors() const;
  const std::vector<QuantityInfo>& metrics() const;

  void add_scenario(const ScenarioRecord& record, const Scenario& scenario,
                    const References& references) {
    add_scenario(record, PackedScenario(scenario, references), references.timing);
  }
  void add_scenario(const ScenarioRecord& record, const PackedScenario& packed,
                    const ReferenceTiming& timing);
  void add_run(const RunRecord& run, const RunTiming& timing, const PackedTrajectory& trajectory);
  void add_run(const RunRecord& run);  ///< without trajectory and times
  /// Makes everything added so far durable; false if the file is being read by a program that does
  /// not release it within `patience` (s): it can be tried again. Throws Error (Job) if the file
  /// was removed, renamed, replaced or truncated; its content is then kept beside it, see rescue().
  bool commit(double patience = 10);
  /// Writes all content, also what is not committed, to PATH.rescued. Returns a part of a sentence
  /// about it: "12 runs are kept in PATH.rescued", or that they cannot be kept.
  std::string rescue() const;
  /// Opens the file at the path anew. Throws Error (Job) unless it contains `count` runs.
  void expect_runs(std::size_t count) const;

  Manifest read_manifest() const;
  /// Replaces the manifest, with the next commit().
  void replace_manifest(const Manifest& manifest);
  std::vector<std::string> read_methods() const;  ///< of all runs, sorted, without duplicates
  bool has_scenario(const std::string& hash) const;
  std::map<std::string, std::string> read_scenario_names() const;  ///< by hash
  /// Calls `use` with scenario hash, method, repetition and outcome of each run, in any order.
  void for_each_key(const std::function<void(const std::string&, const std::string&, int,
                                             const std::string&)>& use) const;
  /// Calls `use` for each run, one by one, by scenario name, hash, method and repetition. Damaged
  /// runs are passed to `report`; without it they are errors.
  void for_each_run(const std::function<void(const RunRecord&)>& use,
                    const DamageHandler& report = {}) const;
  /// The runs of one scenario by method and repetition, without reading the others. Damaged ones as
  /// above.
  std::vector<RunRecord> read_runs(const std::string& scenario_hash,
                                   const DamageHandler& report = {}) const;
  /// None if the file does not contain it.
  std::optional<RunRecord> read_run(const std::string& scenario_hash, const std::string& method,
                                    int repetition) const;
  RunTiming read_timing(const RunRecord& run) const;
  /// The descriptors of a scenario; none if the file does not contain it.
  ScenarioRecord read_record(const std::string& scenario_hash) const;
  Scenario read_scenario(const std::string& hash) const;
  References read_references(const std::string& hash) const;
  Trajectory read_trajectory(const RunRecord& run) const;

 private:
  struct Impl;
  explicit ResultFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// One run as a line of JSON with sorted keys, as printed by `dump`. Independent of the wall clock.
std::string dump_line(const std::string& campaign, const ScenarioRecord& scenario,
                      const RunRecord& run);
/// "/outcome was "success" and is "collision", and 2 more values"; "" for equal lines of dumps.
std::string line_difference(const std::string& before, const std::string& now);

/// Writes all runs of a file as such lines, one at a time. Damaged runs, and those of damaged
/// scenarios, are passed to `report`; without it they are errors.
void dump(const ResultFile& file, std::ostream& out, const DamageHandler& report = {});

/// Writes `content` to a temporary file next to `path` and renames it. Throws Error (Job).
void write_file_atomically(const std::string& path, const std::string& content);
/// The same with the content that `write` writes; if it throws, the file remains as it was.
void write_file_atomically(const std::string& path,
                           const std::function<void(std::ostream&)>& write);

}  // namespace slalom
