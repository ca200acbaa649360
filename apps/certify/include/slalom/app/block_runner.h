// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/campaign_program.h>
#include <slalom/app/parameter.h>
#include <slalom/campaign/run_draws.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A method with other values of its options, as texts by key. Throws Error (Usage) for one that is
/// unknown.
using ConfigureMethod = std::function<NamedMethod(const std::map<std::string, std::string>&)>;

/// A method and the campaign in which it runs.
struct MethodCampaign {
  IniFile ini;
  CampaignOptions options;
  NamedMethod method;
  Manifest files;           ///< hashes of what the method consists of, see hash_method_files()
  bool one_worker = false;  ///< see CampaignConfig
  ConfigureMethod configure = nullptr;
};

/// The campaign with this method only. Throws Error (Usage) at --method for an unknown one.
MethodCampaign read_method_campaign(IniFile ini, const std::string& method);

/// A parameter with a value of its own in each run, drawn uniformly in some of its bins.
struct DrawnParameter {
  Parameter parameter;
  Bins bins;
  BinRange range;
};

/// Runs of one distribution: the scenarios of an .ini with drawn parameters, or given ones. Streams
/// of different names are independent.
struct RunStream {
  std::string name, title;  ///< of the random numbers; for people
  IniFile ini;
  std::vector<DrawnParameter> parameters = {};
  std::shared_ptr<const std::vector<Scenario>> scenarios =
      nullptr;                                       ///< of the runs, by their index
  std::optional<NamedMethod> method = std::nullopt;  ///< instead of that of the campaign
};

/// A run of a stream.
struct BlockRun {
  Outcome outcome = Outcome::InfrastructureError;
  std::optional<double> value;  ///< of the metric of the execution
  std::uint64_t digest = 0;     ///< of scenario and trajectory
  std::size_t index = 0;        ///< of its draw in the stream
};
using ReceiveRun = std::function<bool(const BlockRun& run)>;

/// The hash of several streams, of the hash of each by its name.
std::string hash_of_streams(const std::map<std::string, std::string>& hashes);

/// How runs are executed; neither workers nor interruption affect a run.
struct BlockExecution {
  int workers = 1;
  bool quiet = false;
  std::string journal = {};   ///< file of the runs so far, for the next attempt; "": none
  std::string identity = {};  ///< of the question; a journal of another one is refused
  std::string metric = {};    ///< see DrawExecution
  std::function<bool()> interrupted = nullptr;  ///< polled
};

/// Runs a method in streams of runs. A run is executed once: whoever asks for the first runs of a
/// stream again, also after an interruption, gets those from the journal.
class BlockRunner {
 public:
  /// Throws Error: Usage for a journal of another question, File for one that cannot be written.
  BlockRunner(const MethodCampaign& campaign, BlockExecution execution);

  /// Throws Error (Usage) for a stream that cannot be drawn. Reads its maps.
  void check(const RunStream& stream) const;

  /// Passes the runs of the stream from the first one on, in order, to `receive` until it returns
  /// false, or `max_runs` of them. A draw that the robot cannot solve is a run only if its stream
  /// has parameters, whose values it may be due to; else another one takes its place. Throws
  /// Interrupted, and Error (Job) for runs that cannot be executed or drawn.
  void run(const RunStream& stream, std::size_t max_runs, const ReceiveRun& receive);

  /// The scenario and the options of a draw; none if the sources give no scenario that is solvable.
  std::optional<RunDraw> draw(const RunStream& stream, std::size_t index) const;

  /// Draws of a stream that are no runs, among those up to the last run that was passed on.
  std::size_t redrawn(const RunStream& stream) const;

  /// Hash of scenarios, outcomes and trajectories of the runs that were passed on: of a stream, or
  /// of all whose names have the prefix, in the order of the names.
  std::string hash(const std::string& stream) const;
  std::string hash_all(const std::string& prefix) const;

  /// To be called when the question is answered.
  void remove_journal();

  /// The runs that the method itself ended by an error, "3 runs ended by errors of the method, such
  /// as method_error: DETAIL"; "" if none. Throws Error (Usage) if all did.
  std::string method_failures() const;

  int workers() const { return execution_.workers; }

  /// ms of wall-clock time; the largest 99 % quantile of a run's control cycles. None without runs.
  std::optional<double> cycle_time() const { return cycle_time_; }

 private:
  struct Stream {
    std::vector<BlockRun> runs;
    std::size_t passed = 0;
  };

  void read_journal();
  void write_journal(const std::string& stream, const BlockRun& run);

  const MethodCampaign& campaign_;
  BlockExecution execution_;
  MapLoader load_map_;
  std::map<std::string, Stream> streams_;
  std::ofstream journal_;
  std::string journal_text_;    ///< with which the file begins
  std::string journal_stream_;  ///< of its last line
  std::optional<double> cycle_time_;
  std::string first_failure_;  ///< of this process, with its detail
};

}  // namespace slalom
