// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/methods/registry.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {
namespace {

/// Calls of the methods of a test, in order.
std::vector<std::string> log;

/// Commands v = gain, which can be set.
class Gain : public Method {
 public:
  void reset(const NavigationTask&) override { log.emplace_back("inner begins"); }
  Command step(const Observation&) override { return {gain_}; }
  void set_parameter(const std::string& name, const std::string& value) override {
    log.push_back(name + " = " + value);
    gain_ = std::stod(value);
  }
  bool uses_map() const override { return true; }
  std::map<std::string, double> run_figures() const override { return {{"commands_missing", 7}}; }
  void finish(const std::string& outcome) override { log.push_back("inner: " + outcome); }

 private:
  double gain_ = 1;
};

/// Sets the gain to 2 from the time 1 s on, and to 3 from 3 s on.
class Schedule : public Method {
 public:
  void reset(const NavigationTask&) override { log.emplace_back("outer begins"); }
  Command step(const Observation&) override { return {-1}; }
  bool adapts() const override { return true; }
  std::map<std::string, std::string> adapt(const Observation& observation) override {
    if (observation.time < 1) return {};
    return {{"gain", observation.time < 3 ? "2" : "3"}};
  }
  bool uses_tracks() const override { return true; }
  std::vector<TunableParameter> tunable_parameters() const override { return {{"of_outer"}}; }
  void finish(const std::string& outcome) override { log.push_back("outer: " + outcome); }
};

class Plain : public Method {
 public:
  void reset(const NavigationTask&) override {}
  Command step(const Observation&) override { return {}; }
};

template <typename M>
MethodFactory made() {
  return [](const RobotModel&, const SensorModel&) { return std::make_unique<M>(); };
}

std::vector<double> run_for(Method& method, int seconds) {
  log.clear();
  method.reset({});
  std::vector<double> speeds;
  for (int time = 0; time < seconds; ++time) {
    Observation observation;
    observation.time = time;
    speeds.push_back(method.step(observation).v);
  }
  return speeds;
}

TEST(AdaptiveMethod, SetsWhatChangesBeforeTheStepsOfTheInnerMethod) {
  const auto method = adaptive_method(made<Schedule>(), made<Gain>(), "here")({}, {});
  EXPECT_EQ(run_for(*method, 5), (std::vector<double>{1, 2, 2, 3, 3}));
  method->finish("success");
  EXPECT_EQ(log, (std::vector<std::string>{"outer begins", "inner begins", "gain = 2", "gain = 3",
                                           "outer: success", "inner: success"}));
}

TEST(AdaptiveMethod, BeginsEachRunWithTheParametersOfTheInnerMethod) {
  const auto method = adaptive_method(made<Schedule>(), made<Gain>(), "here")({}, {});
  const std::vector<double> first = run_for(*method, 5);
  EXPECT_EQ(run_for(*method, 5), first);
  EXPECT_EQ(run_for(*method, 2), (std::vector<double>{1, 2}));
}

/// Takes a part of the value before it fails.
class Partial : public Gain {
 public:
  void set_parameter(const std::string& name, const std::string& value) override {
    Gain::set_parameter(name, value);
    throw MethodError("half done");
  }
};

TEST(AdaptiveMethod, BeginsEachRunAnewAfterAParameterThatFailedInPart) {
  const auto method = adaptive_method(made<Schedule>(), made<Partial>(), "here")({}, {});
  EXPECT_THROW(run_for(*method, 2), MethodError);
  EXPECT_EQ(run_for(*method, 1), std::vector<double>{1});
}

TEST(AdaptiveMethod, NeedsWhatEitherNeedsAndIsTunedByTheOuterOne) {
  const auto method = adaptive_method(made<Schedule>(), made<Gain>(), "here")({}, {});
  EXPECT_TRUE(method->uses_tracks());
  EXPECT_TRUE(method->uses_map());
  EXPECT_FALSE(method->is_paced());
  ASSERT_EQ(method->tunable_parameters().size(), 1U);
  EXPECT_EQ(method->tunable_parameters()[0].name, "of_outer");
  EXPECT_EQ(method->run_figures().at("commands_missing"), 7);
}

TEST(AdaptiveMethod, EndsTheRunWhereAMethodTakesNoParameters) {
  const auto method = adaptive_method(made<Schedule>(), made<Plain>(), "here")({}, {});
  method->reset({});
  Observation observation;
  method->step(observation);
  observation.time = 1;
  try {
    method->step(observation);
    FAIL() << "was set";
  } catch (const MethodError& error) {
    EXPECT_STREQ(error.what(),
                 "'gain' cannot be set during a run: the method has no set_parameter()");
  }
}

TEST(AdaptiveMethod, RefusesAnOuterMethodThatSetsNothing) {
  const MethodFactory make = adaptive_method(made<Gain>(), made<Plain>(), "a.ini:3: inner");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "a.ini:3: inner",
                           {"sets no parameters", "adapt(observation)"}, [&] { make({}, {}); }));
}

TEST(AdaptiveMethod, IsReadFromTheKeyInner) {
  MethodRegistry registry;
  const auto reader = [](const MethodFactory& make) {
    return [make](const IniFile& ini, const std::string& section) {
      AdapterReader(ini, section).reject_unknown_keys();
      return make;
    };
  };
  registry.add("schedule", reader(made<Schedule>()));
  registry.add("gain", reader(made<Gain>()));
  const IniFile ini = IniFile::from_text(
      "[method.a]\nadapter = schedule\ninner = safe\n"
      "[method.safe]\nfilter = cbf\nbase = g\n[method.g]\nadapter = gain\n"
      "[method.b]\nadapter = gain\ninner = b\n"
      "[method.c]\nadapter = gain\ninner = g\n"
      "[method.d]\nadapter = schedule\ninner =\n",
      "campaign.ini");
  EXPECT_EQ(method_sections(ini, "a"),
            (std::vector<std::string>{"method.a", "method.safe", "method.g"}));
  const auto refused = [&](const std::string& name, const std::string& where,
                           std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, where, words,
                        [&] { registry.read(ini, name).make({}, {}); });
  };
  EXPECT_NE(registry.read(ini, "a").make({}, {}), nullptr);
  EXPECT_TRUE(refused("b", "campaign.ini:11: [method.b] inner", {"'b' is around itself"}));
  EXPECT_TRUE(refused("c", "campaign.ini:14: [method.c] inner", {"sets no parameters"}));
  EXPECT_TRUE(refused("d", "campaign.ini:17: [method.d] inner", {"missing inner", "inner = NAME"}));
}

}  // namespace
}  // namespace slalom
