#pragma once

#include <slalom/results/run_record.h>

#include <string>
#include <utility>

namespace slalom {

/// A hand-made result table: scenarios "s0", "s1", ... and runs on them.
struct ResultFixture {
  ResultTable table;

  ResultFixture() {
    table.quantities["density"] = {"density", 1, "Density", "-", Direction::None};
    table.quantities["clearness"] = {"clearness", 1, "Clearness", "-", Direction::None};
    table.quantities["success"] = {"success", 1, "Success", "-", Direction::Up};
    table.quantities["optimality"] = {"optimality", 2, "Optimality", "-", Direction::Up};
    table.quantities["path_length"] = {"path_length", 1, "Path length", "m", Direction::Down};
  }

  /// Returns the scenario's hash.
  std::string add_scenario(const Value& density) {
    const std::string hash = std::string(31, 'a') + std::to_string(table.scenarios.size());
    ScenarioRecord scenario{hash, "s" + std::to_string(table.scenarios.size()), {}};
    scenario.descriptors["density"] = {1, density};
    scenario.descriptors["clearness"] = {1, Value::of(0.5)};
    table.scenarios[hash] = scenario;
    return hash;
  }

  /// A success with this optimality, or (negative) a collision.
  RunRecord& add_run(const std::string& hash, const std::string& method, double optimality,
                     int repetition = 0) {
    const bool success = optimality >= 0;
    RunRecord run;
    run.scenario_hash = hash;
    run.scenario_name = table.scenarios[hash].name;
    run.method = method;
    run.repetition = repetition;
    run.outcome = success ? "success" : "collision";
    run.metrics["success"] = {1, Value::of(success ? 1 : 0)};
    run.metrics["optimality"] = {2, success ? Value::of(optimality) : Value::na("collision")};
    run.metrics["path_length"] = {1, Value::of(10)};
    table.runs.push_back(std::move(run));
    table.timings.push_back({1.0, {{"cycle_time_mean", 0.25}}});
    return table.runs.back();
  }
};

}  // namespace slalom
