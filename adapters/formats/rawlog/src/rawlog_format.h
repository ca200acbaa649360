// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>

#include <string>
#include <vector>

namespace slalom {

/// Version of the comments in the rawlog of a run.
constexpr const char* kFormatVersion = "1";

/// Labels of the observations. (MRPT does not store labels of comments.)
constexpr const char* kOdometryLabel = "odometry";
constexpr const char* kTruthLabel = "ground_truth";
constexpr const char* kCommandLabel = "command";

/// Keys of the two comments: the manifest before the cycles, the result after them.
namespace keys {
constexpr const char* kFormat = "slalom_run";
constexpr const char* kCampaignIni = "campaign.ini";
constexpr const char* kScenarioName = "scenario.name";
constexpr const char* kScenarioHash = "scenario.hash";
constexpr const char* kScenarioYaml = "scenario.yaml";
constexpr const char* kMethod = "method";
constexpr const char* kRepetition = "repetition";
constexpr const char* kSeed = "seed";
constexpr const char* kStart = "task.start";
constexpr const char* kGoal = "task.goal";
constexpr const char* kGoalTolerance = "task.goal_tolerance";
constexpr const char* kGoalHeading = "task.goal_heading";  ///< with its tolerance; optional
constexpr const char* kControlPeriod = "task.control_period";
constexpr const char* kTaskSeed = "task.seed";
constexpr const char* kOutcome = "outcome";
constexpr const char* kDetail = "outcome_detail";
constexpr const char* kTrajectoryHash = "trajectory.hash";
constexpr const char* kTrajectory = "trajectory";
}  // namespace keys

/// The timestamp of time 0 of every recorded run.
mrpt::Clock::time_point logged_start();
mrpt::Clock::time_point logged_time(double seconds);  ///< s since the start of the run

std::string format_numbers(const std::vector<double>& numbers);  ///< exact, blank-separated

/// Parses exactly `count` numbers; false on error.
bool parse_numbers(const std::string& text, std::size_t count, double* numbers);

}  // namespace slalom
