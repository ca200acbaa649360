// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/result_file.h>

#include <cmath>
#include <string>
#include <vector>

namespace slalom {

/// A room of 10 x 6 m with a disc of radius 1 m about (5, 4), from (1, 1) to (9, 1).
inline Scenario overlay_room(const std::string& name = "room", double goal_x = 9) {
  Primitives obstacles;
  obstacles.discs.push_back({{5, 4}, 1});
  return Scenario::continuous(name, {0, 0, 10, 6}, obstacles, {1, 1, 0}, {goal_x, 1});
}

/// Straight along y = 1 from x = 1 at this speed (m/s), one sample every 0.5 s, times from 10 s.
inline Trajectory straight_run(double speed, int samples) {
  Trajectory trajectory;
  for (int i = 0; i < samples; ++i)
    trajectory.samples.push_back({10 + 0.5 * i, {1 + speed * 0.5 * i, 1, 0}, speed, 0, speed, 0});
  return trajectory;
}

inline RunRecord overlay_record(const Scenario& scenario, const std::string& method, int repetition,
                                const std::string& outcome) {
  RunRecord run;
  run.scenario_hash = scenario.hash();
  run.scenario_name = scenario.name();
  run.method = method;
  run.repetition = repetition;
  run.outcome = outcome;
  run.outcome_detail = "outcome detail";
  run.metrics["path_length"] = {1, Value::of(8)};
  run.metrics["time_to_goal"] = {
      1, outcome == "success" ? Value::of(8) : Value::na("outcome: " + outcome)};
  return run;
}

/// Runs of nd (8 s), ptg (three repetitions: 4 s, 2 s and one without a trajectory) in the room,
/// and one of vfh in another scenario.
inline void write_overlay_sample(const std::string& path, const Manifest& manifest) {
  const std::vector<QuantityInfo> metrics = {
      {"path_length", 1, "Path length", "m", Direction::Down},
      {"time_to_goal", 1, "Time to goal", "s", Direction::Down}};
  const Scenario room = overlay_room(), other = overlay_room("other", 8);
  ResultFile file = ResultFile::create(path, manifest, {}, metrics);
  for (const Scenario& scenario : {room, other})
    file.add_scenario({scenario.hash(), scenario.name(), {}}, scenario, {});
  file.add_run(overlay_record(room, "nd", 0, "success"), {}, straight_run(1, 17));
  file.add_run(overlay_record(room, "ptg", 0, "success"), {}, straight_run(2, 9));
  file.add_run(overlay_record(room, "ptg", 1, "stuck"), {}, straight_run(2, 5));
  file.add_run(overlay_record(room, "ptg", 2, "method_crash"), {}, {});
  file.add_run(overlay_record(other, "vfh", 0, "success"), {}, straight_run(1, 3));
  file.commit();
}

}  // namespace slalom
