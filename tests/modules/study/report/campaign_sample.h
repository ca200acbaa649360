// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/io/result_file.h>

#include <string>
#include <vector>

namespace slalom {

/// The size of a made-up campaign.
struct CampaignSize {
  int methods = 4, scenarios = 70, repetitions = 1;
};

/// Made-up results as large as those of the demo: 41 metrics and 24 descriptors, five outcomes.
class CampaignSample {
 public:
  explicit CampaignSample(const CampaignSize& size) : size_(size) {}

  void write(const std::string& path) {
    const Manifest manifest = {{"campaign", "made up"},
                               {"campaign.ini",
                                "[analysis]\nrows = density:0,0.25,0.5,0.75,1; confinement:q4\n"
                                "columns = success, optimality, safety, spl, time_to_goal\n"}};
    const auto descriptors = infos({"density", "confinement"}, 24, "descriptor_");
    const auto metrics =
        infos({"success", "optimality", "safety", "spl", "time_to_goal"}, 41, "metric_");
    ResultFile file = ResultFile::create(path, manifest, descriptors, metrics);
    for (int i = 0; i < size_.scenarios; ++i) add_scenario(file, i, descriptors, metrics);
    file.commit();
  }

 private:
  CampaignSize size_;
  RandomEngine random_{1};

  static std::vector<QuantityInfo> infos(const std::vector<std::string>& first, std::size_t count,
                                         const std::string& prefix) {
    std::vector<QuantityInfo> made;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string id = i < first.size() ? first[i] : prefix + std::to_string(i);
      if (id == success_info().id) {
        made.push_back(success_info());
        continue;
      }
      made.push_back({id, 1, "The " + id + " of the whole run, from its start to its end",
                      id == "time_to_goal" ? "s" : "-",
                      i < first.size() ? Direction::Up : Direction::None});
    }
    return made;
  }

  void add_scenario(ResultFile& file, int index, const std::vector<QuantityInfo>& descriptors,
                    const std::vector<QuantityInfo>& metrics) {
    const Primitives obstacles = {{{{5, 5}, 0.5 + 0.0001 * index}}, {}};
    const Scenario scenario =
        Scenario::continuous("a_building_with_many_rooms_" + std::to_string(index), {0, 0, 10, 10},
                             obstacles, {1, 1, 0}, {9, 9});
    ScenarioRecord record{scenario.hash(), scenario.name(), {}};
    for (const QuantityInfo& info : descriptors)
      record.descriptors[info.id] = {1, Value::of(uniform_real(random_, 0, 1))};
    References references;
    references.safest_reason = "not requested";
    file.add_scenario(record, scenario, references);
    for (int method = 0; method < size_.methods; ++method)
      for (int repetition = 0; repetition < size_.repetitions; ++repetition)
        file.add_run(run(scenario, method, repetition, metrics), {}, {});
  }

  RunRecord run(const Scenario& scenario, int method, int repetition,
                const std::vector<QuantityInfo>& metrics) {
    static const char* const kFailures[] = {"collision", "stuck", "timeout", "left_workspace"};
    RunRecord record;
    record.scenario_hash = scenario.hash();
    record.scenario_name = scenario.name();
    record.method = "method " + std::to_string(method);
    record.repetition = repetition;
    const bool reached = uniform_real(random_, 0, 1) < 0.9 - 0.15 * method;
    record.outcome = reached ? "success" : kFailures[uniform_int(random_, 0, 3)];
    for (const QuantityInfo& info : metrics)
      record.metrics[info.id] = {1, reached ? Value::of(uniform_real(random_, 0, 1))
                                            : Value::na("outcome: " + record.outcome)};
    record.metrics["success"] = {1, Value::of(reached ? 1 : 0)};
    return record;
  }
};

}  // namespace slalom
