// SPDX-License-Identifier: BSD-3-Clause
#include "wire.h"

#include <slalom/core/random.h>
#include <slalom/io/scenario_list.h>

#include <gtest/gtest.h>

#include <limits>

namespace slalom {
namespace {

RunFindings sample_run() {
  RunFindings findings;
  RunRecord& r = findings.record;
  r.scenario_hash = "abc";
  r.scenario_name = "a \"name\"\n";
  r.method = "nd";
  r.repetition = 3;
  r.seed = 0xffffffffffffffffULL;
  r.outcome = "success";
  r.outcome_detail = "goal reached";
  r.trajectory_hash = "def";
  r.metrics["optimality"] = {2, Value::of(0.1 + 0.2)};
  r.metrics["safety"] = {1, Value::na("outcome: collision")};
  r.metrics["with_error"] = {1, Value::of(0.5, 1e-300)};
  findings.timing = {1.25, {{"cycle_time_mean", 0.007}}};
  RandomEngine engine(5);
  Trajectory trajectory;
  for (int i = 0; i < 100; ++i) {
    const auto x = [&] { return normal(engine, 0, 1); };
    trajectory.samples.push_back({0.1 * i, {x(), x(), x()}, x(), x(), x(), x()});
  }
  findings.trajectory = trajectory;
  return findings;
}

TEST(Wire, ARunIsRestoredExactly) {
  const RunFindings sent = sample_run();
  const RunFindings received = run_findings_from_wire(to_wire(sent));
  EXPECT_EQ(to_wire(received), to_wire(sent));
  EXPECT_EQ(received.trajectory.unpack("").hash(), sent.trajectory.unpack("").hash());
  EXPECT_EQ(received.record.seed, sent.record.seed);
  EXPECT_EQ(received.record.metrics.at("optimality").value, Value::of(0.1 + 0.2));
  EXPECT_EQ(received.record.metrics.at("optimality").version, 2);
  EXPECT_EQ(received.record.metrics.at("safety").value.reason(), "outcome: collision");
  EXPECT_EQ(received.record.metrics.at("with_error").value.standard_error(), 1e-300);
  EXPECT_EQ(received.timing.values, sent.timing.values);
}

ScenarioFindings sample_scenario(const References& references) {
  const auto scenario = Scenario::continuous("name", {0, 0, 4, 4}, {}, {1, 1, 0}, {3, 3});
  return {{scenario.hash(), "name", {}}, references, {scenario, references}};
}

TEST(Wire, AScenarioIsRestoredWithItsReferences) {
  References references;
  references.shortest = ShortestPath{{{0, 0}, {1, 2}}, 2.5, {2.4, 2.5}, "exact", "a note", 2.5};
  references.shortest->planner_length = 2.75;
  references.timing = {0.1, 0.2, 0.3};
  references.safest_reason = "start is not free";
  ScenarioFindings sent = sample_scenario(references);
  sent.record.descriptors["density"] = {1, Value::of(0.25)};
  const ScenarioFindings received = scenario_findings_from_wire(to_wire(sent));
  EXPECT_EQ(to_wire(received), to_wire(sent));
  EXPECT_EQ(received.packed.refs, sent.packed.refs);
  EXPECT_EQ(deserialize_scenario(received.packed.content, "").hash(), sent.record.hash);
  ASSERT_TRUE(received.references.shortest.has_value());
  EXPECT_EQ(received.references.shortest->path.back().y, 2);
  EXPECT_EQ(received.references.shortest->certificate.lower_bound, 2.4);
  EXPECT_EQ(received.references.shortest->planner_length, 2.75);
  EXPECT_EQ(received.references.timing.planner, 0.2);
  EXPECT_FALSE(received.references.safest.has_value());
  EXPECT_EQ(received.references.safest_reason, "start is not free");
}

TEST(Wire, RejectsDamagedBytes) {
  const std::string bytes = to_wire(sample_run());
  for (std::size_t size = 0; size < bytes.size(); size += 97)
    EXPECT_THROW(run_findings_from_wire(bytes.substr(0, size)), std::exception);
  EXPECT_THROW(run_findings_from_wire("garbage"), std::exception);
}

TEST(Wire, NoticesEveryChangedByte) {
  const std::string bytes = to_wire(sample_run());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    EXPECT_THROW(run_findings_from_wire(changed), std::exception) << "byte " << i;
  }
}

TEST(Wire, RejectsTimesThatCannotBeStored) {
  RunFindings run = sample_run();
  run.timing.wall_seconds = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(run_findings_from_wire(to_wire(run)), std::exception);
  References references;
  references.timing.planner = 1;
  EXPECT_NO_THROW(scenario_findings_from_wire(to_wire(sample_scenario(references))));
  references.timing.planner = std::numeric_limits<double>::infinity();
  EXPECT_THROW(scenario_findings_from_wire(to_wire(sample_scenario(references))), std::exception);
}

TEST(Wire, RejectsPackedReferencesThatAreDamaged) {
  ScenarioFindings forged = sample_scenario({});
  for (const std::string& bytes : {std::string(), std::string("garbage"), forged.packed.content}) {
    forged.packed.refs = bytes;
    EXPECT_THROW(scenario_findings_from_wire(to_wire(forged)), std::exception);
  }
}

}  // namespace
}  // namespace slalom
