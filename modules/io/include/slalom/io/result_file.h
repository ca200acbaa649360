#pragma once

#include <slalom/references/reference.h>
#include <slalom/results/run_record.h>
#include <slalom/scenario/scenario.h>
#include <slalom/trajectory/trajectory.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// A result file (.results): one SQLite file with manifest, quantities, scenarios (content,
/// descriptors, references), runs (one row each, one column per metric, NA reasons beside),
/// trajectories (compressed). Wall-clock figures stand in a table of their own. Errors are Error
/// (File).
class ResultFile {
 public:
  /// A new file at `path` (an existing one is replaced). Metric and descriptor columns follow from
  /// `quantities`. Throws Error (Job) when it cannot be written.
  static ResultFile create(const std::string& path, const Manifest& manifest,
                           const std::vector<QuantityInfo>& descriptors,
                           const std::vector<QuantityInfo>& metrics);
  static ResultFile open(const std::string& path);
  ~ResultFile();
  ResultFile(ResultFile&&) noexcept;
  ResultFile& operator=(ResultFile&&) noexcept;

  const std::string& path() const;

  void add_scenario(const ScenarioRecord& record, const Scenario& scenario,
                    const References& references);
  void add_run(const RunRecord& run, const RunTiming& timing, const Trajectory& trajectory);
  void commit();  ///< makes everything added so far survive a kill

  ResultTable read_table() const;  ///< sorted
  Manifest read_manifest() const;
  std::vector<std::string> read_methods() const;  ///< of all runs, sorted, each once
  bool has_scenario(const std::string& hash) const;
  /// Those of one scenario, by method and repetition; quick in a file with very many.
  std::vector<RunRecord> read_runs(const std::string& scenario_hash) const;
  Scenario read_scenario(const std::string& hash) const;
  References read_references(const std::string& hash) const;
  Trajectory read_trajectory(const RunRecord& run) const;

 private:
  struct Impl;
  explicit ResultFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// One run as one line of JSON, keys sorted: what `dump` prints. Nothing in it depends on the
/// clock.
std::string dump_line(const ResultTable& table, const RunRecord& run);

/// Writes `content` to a temporary file beside `path` and renames it; throws Error (Job) when it
/// cannot.
void write_file_atomically(const std::string& path, const std::string& content);
/// Throws Error (File).
std::string read_file(const std::string& path);

}  // namespace slalom
