// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_runs.h"

#include <slalom/rawlog/re_execution.h>

#include <error_text.h>

namespace slalom {
namespace {

class ReExecution : public testing::RecordedRunTest {};

/// Uses all inputs of a method: if any of them is lost, the answers differ.
class MixingMethod : public Method {
 public:
  void reset(const NavigationTask& task) override {
    state_ = task.start.phi + task.goal.x + 1e-19 * static_cast<double>(task.seed);
  }
  Command step(const Observation& o) override {
    // In ticks: the difference of two times as double depends on the start time of the run.
    const double age = 1e-7 * static_cast<double>((mrpt::Clock::now() - o.scan->timestamp).count());
    state_ = 0.5 * state_ + std::sin(o.time + o.odometry.x + o.odometry.phi + o.v - o.w + age) +
             0.1 * o.goal_in_robot.y;
    for (std::size_t i = 0; i < o.scan->getScanSize(); ++i)
      state_ += 1e-3 * o.scan->getScanRange(i) * (o.scan->getScanRangeValidity(i) ? 1 : -1);
    return {0.5 + 0.3 * std::sin(state_), 1.2 * std::cos(state_)};
  }

 private:
  double state_ = 0;
};

TEST_F(ReExecution, TheSameMethodGivesIdenticalCommands) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    MixingMethod method;
    testing::simulate_run(path("run.rawlog"), method, testing::noisy_setup(), seed);
    MixingMethod again;
    EXPECT_EQ(first_difference(read_run(path("run.rawlog")), again), std::nullopt);
  }
}

TEST_F(ReExecution, ReportsTheFirstDifference) {
  auto method = testing::constant_method(0.4, 0.05);
  testing::simulate_run(path("run.rawlog"), method, {});
  const RecordedRun run = read_run(path("run.rawlog"));
  testing::FunctionMethod later([](const Observation& o) {
    return Command{o.time < 0.35 ? 0.4 : std::nextafter(0.4, 1), 0.05};
  });
  // Cycles at 0, 0.1, 0.2, 0.3, 0.4 s: the fifth is the first that differs, by the last bit.
  EXPECT_TRUE(mentions(first_difference(run, later).value_or(""),
                       {"cycle 5 (0.40 s): ", "recorded v = 0.4,", "v = 0.4000000000000001"}));
  testing::FunctionMethod minus_zero([](const Observation&) { return Command{0.4, 0.05, -0.0}; });
  EXPECT_TRUE(mentions(first_difference(run, minus_zero).value_or(""),
                       {"cycle 1 (0.00 s): ", "recorded vy = 0,", "vy = -0"}));
}

TEST_F(ReExecution, AMethodErrorIsADifference) {
  auto method = testing::constant_method(0.4, 0);
  testing::simulate_run(path("run.rawlog"), method, {});
  testing::FunctionMethod failing(
      [](const Observation&) -> Command { throw MethodError("no idea"); });
  EXPECT_TRUE(mentions(first_difference(read_run(path("run.rawlog")), failing).value_or(""),
                       {"cycle 1 (0.00 s): ", "method failed", "(no idea)"}));
}

}  // namespace
}  // namespace slalom
