#pragma once

#include <mrpt/core/Clock.h>

#include <string>
#include <vector>

namespace slalom {

/// Version of what stands in the comments of a run's rawlog.
constexpr const char* kFormatVersion = "1";

/// Labels of the observations. (Of comments MRPT keeps none.)
constexpr const char* kOdometryLabel = "odometry";
constexpr const char* kTruthLabel = "ground_truth";
constexpr const char* kCommandLabel = "command";

/// Keys of both comments: the manifest before the cycles, the result behind them.
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
constexpr const char* kControlPeriod = "task.control_period";
constexpr const char* kTaskSeed = "task.seed";
constexpr const char* kOutcome = "outcome";
constexpr const char* kDetail = "outcome_detail";
constexpr const char* kTrajectoryHash = "trajectory.hash";
constexpr const char* kTrajectory = "trajectory";
}  // namespace keys

/// The instant that time 0 of every recorded run has: that of a process's first run.
mrpt::Clock::time_point logged_start();
mrpt::Clock::time_point logged_time(double seconds);  ///< since the start of the run

std::string format_numbers(const std::vector<double>& numbers);  ///< exact, separated by blanks

/// `count` numbers, or false.
bool parse_numbers(const std::string& text, std::size_t count, double* numbers);

}  // namespace slalom
