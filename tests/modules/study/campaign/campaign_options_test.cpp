// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/campaign/campaign_options.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/metrics/mover_metrics.h>

#include <gtest/gtest.h>

#include <initializer_list>

namespace slalom {
namespace {

constexpr char kMinimal[] = "[campaign]\nmethods = a, b\n[method.a]\n[method.b]\n";

/// Methods that cannot be made.
MethodRegistry registry_of_one() {
  MethodRegistry registry;
  registry.add("test", [](const IniFile&, const std::string&) { return MethodFactory(); });
  return registry;
}

testing::AssertionResult refused(const std::string& text, const std::string& where,
                                 std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, where, words,
                      [&] { read_campaign_options(IniFile::from_text(text, "c.ini")); });
}

testing::AssertionResult refused_methods(const std::string& text, const std::string& where,
                                         std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, where, words,
                      [&] { read_methods(IniFile::from_text(text, "c.ini"), registry_of_one()); });
}

TEST(CampaignOptions, DefaultsAreTheRobotOfTheFrameworkPaper) {
  const CampaignOptions options = read_campaign_options(IniFile::from_text(kMinimal));
  EXPECT_EQ(options.sensor.rays, 181);
  EXPECT_EQ(options.sensor.aperture_deg, 180);
  EXPECT_TRUE(options.robot.forward_only);
  EXPECT_FALSE(options.metrics.empty());
  EXPECT_FALSE(options.descriptors.empty());
}

TEST(CampaignOptions, SelectsMetricsAndDescriptors) {
  const CampaignOptions options = read_campaign_options(IniFile::from_text(
      std::string(kMinimal) + "[metrics]\nenabled = spl, success\ndescriptors = density\n"));
  EXPECT_EQ(options.metrics, (std::vector<std::string>{"spl", "success"}));
  EXPECT_EQ(options.descriptors, (std::vector<std::string>{"density"}));
  EXPECT_FALSE(options.exact_confinement);
}

TEST(CampaignOptions, ComputesMetricsAboutMoversOnlyWhenTheyAreNamed) {
  const auto enabled = [](const std::string& words) {
    return read_campaign_options(
               IniFile::from_text(std::string(kMinimal) + "[metrics]\nenabled = " + words + "\n"))
        .metrics;
  };
  const std::vector<std::string> all = enabled("all"), movers = enabled("movers");
  EXPECT_EQ(movers, mover_metric_ids());
  EXPECT_EQ(all, all_metric_ids());
  EXPECT_EQ(
      all.size() + movers.size() + people_metric_ids().size() + goal_heading_metric_ids().size(),
      all_metrics().size());
  for (const std::string& id : movers) EXPECT_FALSE(contains(all, id)) << id;
  std::vector<std::string> both = all;
  both.insert(both.end(), movers.begin(), movers.end());
  EXPECT_EQ(enabled("all, movers"), both);
  EXPECT_EQ(enabled("frozen_time"), (std::vector<std::string>{"frozen_time"}));
  EXPECT_EQ(enabled("frozen_time, movers").size(), movers.size());
  EXPECT_TRUE(refused(std::string(kMinimal) + "[metrics]\nenabled = all, mover\n",
                      "c.ini:6: [metrics] enabled: ", {"'mover'", "expected 'movers'"}));
}

TEST(CampaignOptions, AllIncludesQuantitiesAboutMoversIfAScenarioHasSome) {
  const Scenario still = Scenario::continuous("still", {0, 0, 5, 5}, {}, {1, 1, 0}, {4, 4});
  const Scenario moving = still.with_movers({{"a", 0.3, {{0, {2, 3}}}, MoverEnd::Stop}});
  const auto adapted = [](const std::string& section, const std::vector<Scenario>& scenarios) {
    CampaignOptions options =
        read_campaign_options(IniFile::from_text(std::string(kMinimal) + "[metrics]\n" + section));
    options.adapt_to(scenarios);
    return options;
  };
  EXPECT_EQ(adapted("", {still}).metrics, all_metric_ids());
  EXPECT_EQ(adapted("", {still}).descriptors, all_descriptor_ids());
  const CampaignOptions with_movers = adapted("", {still, moving});
  std::vector<std::string> expected = all_metric_ids();
  expected.insert(expected.end(), mover_metric_ids().begin(), mover_metric_ids().end());
  EXPECT_EQ(with_movers.metrics, expected);
  std::vector<std::string> descriptors = all_descriptor_ids();
  descriptors.insert(descriptors.end(), mover_descriptor_ids().begin(),
                     mover_descriptor_ids().end());
  EXPECT_EQ(with_movers.descriptors, descriptors);
  EXPECT_EQ(adapted("descriptors = predicted_difficulty\n", {still}).descriptors,
            std::vector<std::string>{"predicted_difficulty"});
  const Scenario walked = still.with_people({{"anna", 0.25, 1.3, {2, 3}, {{4, 1}}}});
  std::vector<std::string> with_people = expected;
  with_people.insert(with_people.end(), people_metric_ids().begin(), people_metric_ids().end());
  EXPECT_EQ(adapted("", {still, walked}).metrics, with_people);
  with_people.erase(with_people.begin(),
                    with_people.begin() + static_cast<std::ptrdiff_t>(all_metric_ids().size()));
  EXPECT_EQ(adapted("enabled = movers\n", {walked}).metrics, with_people);
  EXPECT_EQ(adapted("enabled = movers\n", {moving}).metrics, mover_metric_ids());
  EXPECT_EQ(adapted("enabled = success\n", {walked}).metrics, std::vector<std::string>{"success"});
  const Scenario headed = still.with_goal_heading(1);
  expected = all_metric_ids();
  expected.insert(expected.end(), goal_heading_metric_ids().begin(),
                  goal_heading_metric_ids().end());
  EXPECT_EQ(adapted("", {still, headed}).metrics, expected);
  EXPECT_EQ(adapted("", {headed}).descriptors, all_descriptor_ids());
  EXPECT_EQ(adapted("", {headed, walked}).metrics.size(), metric_ids().size());
  const CampaignOptions named =
      adapted("enabled = success\ndescriptors = density, movers\n", {moving});
  EXPECT_EQ(named.metrics, std::vector<std::string>{"success"});
  EXPECT_EQ(named.descriptors.size(), 1 + mover_descriptor_ids().size());
}

TEST(CampaignOptions, OfPeopleAreSettingsOnlyIfTheyAreNotTheDefaults) {
  const IniFile ini = IniFile::from_text(std::string(kMinimal) +
                                         "[people]\nmodel = orca\nnotices = 0.5\nperiod = 0.2\n");
  const CampaignOptions options = read_campaign_options(ini);
  EXPECT_EQ(options.people.model, PeopleModel::Orca);
  EXPECT_EQ(options.people.notices, 0.5);
  EXPECT_EQ(read_measuring_options(ini).people.period, 0.2);
  EXPECT_EQ(read_campaign_options(campaign_ini(options, "")).people.notices, 0.5);
  EXPECT_FALSE(campaign_ini(CampaignOptions(), "").has_section("people"));
}

TEST(CampaignOptions, PeopleDecideInPeriodsOfWholeControlCycles) {
  const std::string control = std::string(kMinimal) + "[simulation]\ncontrol_period = 0.25\n";
  EXPECT_TRUE(refused(control + "[people]\nperiod = 0.3\n", "c.ini:8: [people] period: ",
                      {"0.3 s", "a multiple of control_period (0.25 s)"}));
  EXPECT_TRUE(refused(control + "[people]\nside = left\n", "c.ini: [people] period: ", {"0.1 s"}));
  CampaignOptions options = read_campaign_options(IniFile::from_text(control));
  const Scenario empty = Scenario::continuous("empty", {0, 0, 5, 5}, {}, {1, 1, 0}, {4, 4});
  EXPECT_NO_THROW(options.adapt_to({empty}));
  const Scenario walked = empty.with_people({{"anna", 0.25, 1.3, {2, 3}, {{4, 1}}}});
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "[people] period", {"0.1 s"}, [&] {
    options.adapt_to({empty, walked});
  }));
  options.people.period = 0.5;
  EXPECT_NO_THROW(options.adapt_to({empty, walked}));
  options.people.period = 0.6;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "options people.period", {"0.6 s"},
                           [&] { checked_options(options, "options "); }));
}

TEST(CampaignOptions, TheToleranceOfHeadingsIsASettingOnlyIfItIsNotTheDefault) {
  const auto tolerance = [](const CampaignOptions& options) {
    return campaign_ini(options, "").get("simulation", "goal_heading_tolerance");
  };
  CampaignOptions options;
  EXPECT_EQ(tolerance(options), std::nullopt);
  options.simulation.goal_heading_tolerance = 0.5;
  EXPECT_EQ(tolerance(options), "0.5");
}

TEST(CampaignOptions, LasersAreSettingsByTheirNames) {
  CampaignOptions options;
  const auto sections = campaign_ini(options, "").sections();
  options.sensor.lasers.resize(1);
  options.sensor.lasers[0].name = "front";
  options.sensor.lasers[0].x = 0.2;
  EXPECT_EQ(campaign_ini(options, "").get("laser.front", "x"), "0.2");
  EXPECT_EQ(read_sensor_model(campaign_ini(options, "")).lasers[0].x, 0.2);
  EXPECT_EQ(campaign_ini(options, "").sections().size(), sections.size() + 1);
  options.sensor.lasers[0].rays = 1;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "options laser.front.rays", {"[2, 100000]"},
                           [&] { checked_options(options, "options "); }));
}

TEST(CampaignOptions, OfAProgramMayNameGroupsOfMetrics) {
  CampaignOptions options;
  options.metrics = {"success", "movers"};
  std::vector<std::string> expected = {"success"};
  expected.insert(expected.end(), mover_metric_ids().begin(), mover_metric_ids().end());
  EXPECT_EQ(checked_options(options, "options ").metrics, expected);
}

TEST(CampaignOptions, EnablesExactConfinement) {
  EXPECT_TRUE(read_campaign_options(IniFile::from_text(std::string(kMinimal) +
                                                       "[metrics]\nexact_confinement = true\n"))
                  .exact_confinement);
}

TEST(CampaignOptions, MeasuringOptionsRequireNoMethods) {
  const CampaignOptions options = read_measuring_options(
      IniFile::from_text("[robot]\nradius = 0.4\n[metrics]\nsafe_distance = 0.7\n"));
  EXPECT_EQ(options.robot.radius, 0.4);
  EXPECT_EQ(options.safe_distance, 0.7);
  EXPECT_GT(options.metrics.size(), 40U);
  EXPECT_EQ(read_campaign_options(IniFile::from_text(kMinimal)).safe_distance, 0.5);
  EXPECT_TRUE(refused(std::string(kMinimal) + "[metrics]\nsafe_distance = 0\n",
                      "c.ini:6: [metrics] safe_distance: ", {"'0'", "expected a number > 0"}));
}

TEST(CampaignOptions, RejectsUnknownNamesAndSuggestsTheNearest) {
  EXPECT_TRUE(refused(std::string(kMinimal) + "[metrics]\nenabled = sucess\n",
                      "c.ini:6: [metrics] enabled: ", {"'sucess'", "expected 'success'"}));
}

TEST(CampaignOptions, ReadsTheMethodsInTheirOrder) {
  const IniFile ini = IniFile::from_text(
      "[campaign]\nmethods = b, a\n[method.a]\nadapter = test\n[method.b]\nadapter = test\n",
      "c.ini");
  const std::vector<NamedMethod> methods = read_methods(ini, registry_of_one());
  ASSERT_EQ(methods.size(), 2U);
  EXPECT_EQ(methods[0].name, "b");
  EXPECT_EQ(methods[0].where, "c.ini:5: [method.b]");
  EXPECT_EQ(methods[1].name, "a");
}

TEST(CampaignOptions, RejectsMethodsThatAreMissingOrDuplicate) {
  const std::string methods = "c.ini:2: [campaign] methods: ";
  EXPECT_TRUE(
      refused_methods("[campaign]\nmethods = a\n", methods, {"'a'", "expected [method.a]"}));
  EXPECT_TRUE(refused_methods("[campaign]\nmethods = a,a\n[method.a]\n", methods,
                              {"duplicate", "'a'", "expected each method once"}));
  EXPECT_TRUE(refused_methods("[campaign]\nname = x\n", "c.ini", {"methods", "[method.NAME]"}));
}

TEST(CampaignOptions, RejectsNamesThatAreNoFileNames) {
  for (const std::string name : {"../x", "a/b", ".hidden", "a b", "ümlaut"}) {
    EXPECT_TRUE(refused_methods("[campaign]\nmethods = " + name + "\n",
                                "c.ini:2: [campaign] methods: ", {"invalid name '" + name + "'"}));
    EXPECT_TRUE(refused("[campaign]\nmethods = a\nname = " + name + "\n[method.a]\n",
                        "c.ini:3: [campaign] name: ", {"invalid name '" + name + "'"}));
  }
  const std::string longest(100, 'x');
  EXPECT_EQ(read_campaign_options(IniFile::from_text("[campaign]\nname = " + longest + "\n")).name,
            longest);
}

TEST(CampaignOptions, AreTheSameAfterWritingAndReading) {
  CampaignOptions options;
  options.seed = 7;
  options.repetitions = 3;
  options.metrics = {"success", "spl"};
  options.descriptors = {"density"};
  options.safe_distance = 0.7;
  options.robot.max_v = 0.6;
  options.sensor.rays = 91;
  options.odometry.turn_sigma = 0.01;
  options.simulation.max_time = 30;
  options.deadline.cycle_deadline = 0.5;
  options.limits.run_wall_time = 12;
  EXPECT_FALSE(campaign_ini(options, "options ").has_section("tracks")) << "as it is by default";
  EXPECT_FALSE(campaign_ini(options, "options ").get("record", "bag")) << "as it is by default";
  options.tracker.position_sigma = 0.05;
  options.record.bag = RecordedRuns::Failures;
  const IniFile ini = campaign_ini(options, "options ");
  const CampaignOptions copy = read_campaign_options(ini);
  EXPECT_EQ(copy.metrics, options.metrics);
  EXPECT_EQ(copy.deadline.cycle_deadline, 0.5);
  EXPECT_EQ(copy.limits.run_wall_time, 12);
  EXPECT_EQ(copy.tracker.position_sigma, 0.05);
  EXPECT_EQ(copy.record.bag, RecordedRuns::Failures);
  EXPECT_EQ(campaign_ini(copy, "options ").canonical_text(), ini.canonical_text());
}

TEST(CampaignOptions, OfAProgramAreCheckedLikeThoseOfAFile) {
  const auto checked = [](const CampaignOptions& options) {
    return checked_options(options, "options ");
  };
  CampaignOptions options;
  options.robot.footprint = "0.3,0.4; -0.3,0.4; -0.3,-0.4; 0.3,-0.4";
  EXPECT_DOUBLE_EQ(checked(options).robot.radius, 0.5);
  EXPECT_DOUBLE_EQ(read_campaign_options(campaign_ini(options, "options ")).robot.radius, 0.5);
  options.simulation.step = 0.03;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "options simulation.step: ", {"does not divide"},
                           [&] { checked(options); }));
}

TEST(CampaignOptions, TheStepMustDivideTheControlPeriod) {
  EXPECT_TRUE(refused(std::string(kMinimal) + "[simulation]\nstep = 0.03\ncontrol_period = 0.1\n",
                      "c.ini", {}));
}

}  // namespace
}  // namespace slalom
