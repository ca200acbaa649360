// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/run_campaign.h>
#include <slalom/io/result_file.h>

#include <map>
#include <set>
#include <string>
#include <tuple>

namespace slalom {

/// Scenario hash, method and repetition.
using RunKey = std::tuple<std::string, std::string, int>;
RunKey key_of(const RunRecord& run);

struct ExecutedRun {
  RunRecord record;
  PackedTrajectory trajectory;
};

struct RepeatedRuns {
  bool complete = false;  ///< false if interrupted
  std::map<RunKey, ExecutedRun> runs;
};

/// Executes these runs of the campaign, each in a worker process of its own, without what a method
/// keeps from one run to the next. `file`: contains the references of
/// the scenarios; null: they are computed. Runs that the infrastructure or a time limit ended are
/// left out.
RepeatedRuns execute_again(Campaign campaign, const std::set<RunKey>& runs, const ResultFile* file,
                           Execution execution);

/// "differs after 1.3 s: command v 0.52 and 0.48 m/s": the first value in which two executions of a
/// run differ, of their trajectories if both are given; "" if they are equal.
std::string execution_difference(const RunRecord& before, const Trajectory* trajectory,
                                 const ExecutedRun& again);

}  // namespace slalom
