#include "recorded_runs.h"

#include <slalom/rawlog/re_execution.h>

namespace slalom {
namespace {

class ReExecution : public testing::RecordedRunTest {};

/// Uses all that a method is given: where any of it is lost, the answers differ.
class MixingMethod : public Method {
 public:
  void reset(const Task& task) override {
    state_ = task.start.phi + task.goal.x + 1e-19 * static_cast<double>(task.seed);
  }
  Command step(const Observation& o) override {
    // Ticks: the difference of two instants as double depends on when the run began.
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

TEST_F(ReExecution, TheSameMethodAnswersTheSameBits) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    MixingMethod method;
    testing::make_run(path("run.rawlog"), method, testing::uneven_setup(), seed);
    MixingMethod again;
    EXPECT_EQ(first_difference(read_run(path("run.rawlog")), again), std::nullopt);
  }
}

TEST_F(ReExecution, TheFirstDifferenceIsTold) {
  auto method = testing::constant_method(0.4, 0.05);
  testing::make_run(path("run.rawlog"), method, {});
  const RecordedRun run = read_run(path("run.rawlog"));
  testing::FunctionMethod later([](const Observation& o) {
    return Command{o.time < 0.35 ? 0.4 : std::nextafter(0.4, 1), 0.05};
  });
  // Cycles at 0, 0.1, 0.2, 0.3, 0.4 s: the fifth is the first that differs, by the last bit.
  EXPECT_EQ(first_difference(run, later).value_or(""),
            "cycle 5 (0.40 s): v = 0.4 was recorded, 0.4000000000000001 is answered");
  testing::FunctionMethod minus_zero([](const Observation&) { return Command{0.4, 0.05, -0.0}; });
  EXPECT_EQ(first_difference(run, minus_zero).value_or(""),
            "cycle 1 (0.00 s): vy = 0 was recorded, -0 is answered");
}

TEST_F(ReExecution, AMethodThatFailsDiffers) {
  auto method = testing::constant_method(0.4, 0);
  testing::make_run(path("run.rawlog"), method, {});
  testing::FunctionMethod failing(
      [](const Observation&) -> Command { throw MethodError("no idea"); });
  EXPECT_EQ(first_difference(read_run(path("run.rawlog")), failing).value_or(""),
            "cycle 1 (0.00 s): the method fails (no idea)");
}

}  // namespace
}  // namespace slalom
