// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/output_marks.h>
#include <slalom/results/table_builder.h>
#include <slalom/results/untimely_commands.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(UntimelyCommands, AreAddedOverTheRunsOfTheirMethod) {
  TableBuilder builder({}, {});
  int scenario = 0;
  const auto add = [&](const std::string& method, std::map<std::string, double> figures) {
    RunRecord run;
    run.scenario_hash = run.scenario_name = "room_" + std::to_string(scenario++);
    run.method = method;
    run.outcome = "success";
    builder.add_run(run, {1, std::move(figures)});
  };
  add("node", {{"commands_missing", 3}, {"commands_stale", 0}, {"commands_late", 0}});
  add("node", {{"commands_missing", 0}, {"commands_stale", 0}, {"commands_late", 0}});
  add("node", {{"commands_missing", 2}, {"commands_stale", 0}, {"commands_late", 1}});
  add("other", {{"commands_missing", 0}, {"commands_stale", 7}, {"commands_late", 0}});
  add("library", {{"cycle_time_mean", 1}});
  add("net", {{"commands_limited", 30}});
  add("net", {{"commands_limited", 5}});
  add("net", {{"commands_limited", 0}});
  const ResultTable table = builder.finish();
  EXPECT_EQ(untimely_commands(table, "node"),
            "node: commands were missing (5) or late (1) in 2 of 3 runs, which depend on the speed "
            "of the machine");
  EXPECT_EQ(untimely_commands(table, "other"),
            "other: commands were stale (7) in 1 of 1 run, which depend on the speed of the "
            "machine");
  EXPECT_EQ(untimely_commands(table, "library"), "");
  EXPECT_EQ(untimely_commands(table, "net"), "");
  EXPECT_EQ(limited_commands(table, "node"), "");
  EXPECT_EQ(limited_commands(table, "net"),
            "net: 35 commands in 2 of 3 runs beyond the robot's limits, which changed them");
}

TEST(UntimelyCommands, TheLastErrorThatWasPrintedIsALineOfALogOfRos) {
  EXPECT_EQ(last_error_printed("[INFO] [1.0] [planner]: ready\n[ERROR] [2.0] [planner]: no path\n"
                               "[FATAL] [3.0] [bt]: \x1b[31mend\n[WARN] [4.0] [bt]: slow\n"),
            "[FATAL] [3.0] [bt]: \\x1b[31mend");
  EXPECT_EQ(last_error_printed("all is well\n"), "");
  const std::string end =
      std::string(kEndingOutput) + "[ERROR] context is invalid\n" + kEndedOutput;
  EXPECT_EQ(last_error_printed("[ERROR] no path\n" + end + "[INFO] again\n"), "[ERROR] no path");
  EXPECT_EQ(last_error_printed(end + "[ERROR] later\n"), "[ERROR] later");
  EXPECT_EQ(last_error_printed(end), "");
  EXPECT_EQ(last_error_printed(""), "");
}

}  // namespace
}  // namespace slalom
