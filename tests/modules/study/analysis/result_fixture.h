// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <algorithm>
#include <string>

namespace slalom {

/// A table built by hand: scenarios "s0", "s1", ... and runs in them.
struct ResultFixture {
  ResultTable table;

  ResultFixture() {
    table.descriptors.emplace_back(info("clearness", 1, "-", Direction::None));
    table.descriptors.emplace_back(info("density", 1, "-", Direction::None));
    QuantityInfo optimality = info("optimality", 2, "-", Direction::Up);
    optimality.range = Range::between(0, 1);
    table.metrics.emplace_back(optimality);
    table.metrics.emplace_back(info("path_length", 1, "m", Direction::Down));
    table.metrics.emplace_back(success_info());
    table.metrics.emplace_back(info("cycle_time_mean", 1, "ms", Direction::Down)).wall_clock = true;
  }

  /// Returns the scenario's hash.
  std::string add_scenario(const Value& density) {
    const std::string number = std::to_string(table.scenario_hashes.size());
    table.scenario_hashes.push_back(std::string(31, 'a') + number);
    table.scenario_names.push_back("s" + number);
    table.descriptors[0].add_number(0.5);
    table.descriptors[1].add(density);
    return table.scenario_hashes.back();
  }

  /// A success with this optimality, or (negative) a collision.
  void add_run(const std::string& hash, const std::string& method, double optimality,
               int repetition = 0) {
    const bool success = optimality >= 0;
    table.scenario.push_back(index_of(table.scenario_hashes, hash));
    table.method.push_back(index_of(table.methods, method));
    table.outcome.push_back(index_of(table.outcomes, success ? "success" : "collision"));
    table.repetition.push_back(static_cast<std::uint32_t>(repetition));
    table.metrics[0].add(success ? Value::of(optimality) : Value::na("collision"));
    table.metrics[1].add_number(10);
    table.metrics[2].add_number(success ? 1 : 0);
    table.metrics[3].add_number(0.25);
    table.details.push_back({1, "", "", 1.0});
    sort_names(table);
  }

  void erase_metric(const std::string& id) {
    auto& metrics = table.metrics;
    metrics.erase(std::remove_if(metrics.begin(), metrics.end(),
                                 [&](const ValueColumn& column) { return column.info().id == id; }),
                  metrics.end());
  }

 private:
  static QuantityInfo info(const std::string& id, int version, const std::string& unit,
                           Direction direction) {
    return {id, version, id, unit, direction};
  }

  static std::uint32_t index_of(std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    const auto index = static_cast<std::uint32_t>(found - names.begin());
    if (found == names.end()) names.push_back(name);
    return index;
  }
};

}  // namespace slalom
