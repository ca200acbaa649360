// SPDX-License-Identifier: BSD-3-Clause
// The shipped plug-ins as inner methods, whose parameters change during a run.
#include "places.h"

#include <slalom/core/text.h>
#include <slalom/library/library_method.h>
#include <slalom/methods/registry.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace slalom {
namespace {

using Parameters = std::vector<std::pair<std::string, std::string>>;

constexpr std::array kPlugins = {
    "dwa",  "dwa_local_planner",      "eband_local_planner", "follow_the_gap",    "go_to_goal",
    "mppi", "regulated_pure_pursuit", "rollout_tracks",      "trajectory_rollout"};

std::unique_ptr<Method> create(const std::string& name, const Parameters& parameters = {}) {
  return plugin(kMethods + "/libslalom_" + name + ".so", parameters)({}, {});
}

/// All parameters that can change, of the section beside the source of a plug-in.
Parameters defaults_of(const std::string& name) {
  if (name == "follow_the_gap") return {{"alpha", "1"}, {"margin", "0.1"}, {"look_ahead", "2.5"}};
  const std::string section = "method." + name;
  const std::set<std::string> others = {"adapter", "plugin",     "memory",
                                        "width",   "resolution", "map"};
  Parameters parameters;
  const IniFile ini = IniFile::load(kSource + "/reactive_algos/" + name + "/" + name + ".ini");
  for (const std::string& key : ini.keys(section))
    if (others.count(key) == 0) parameters.emplace_back(key, ini.get(section, key).value());
  return parameters;
}

/// Sets parameters of a method before its steps, one after another or all before the first.
class Setting : public Method {
 public:
  Setting(std::unique_ptr<Method> method, Parameters parameters, bool all_at_first)
      : method_(std::move(method)),
        parameters_(std::move(parameters)),
        all_at_first_(all_at_first) {}
  bool uses_tracks() const override { return method_->uses_tracks(); }
  void reset(const NavigationTask& task) override { method_->reset(task); }
  Command step(const Observation& observation) override {
    for (std::size_t i = 0; i < parameters_.size(); ++i)
      if (all_at_first_ ? step_ == 0 : i == step_ % parameters_.size())
        method_->set_parameter(parameters_[i].first, parameters_[i].second);
    ++step_;
    return method_->step(observation);
  }

 private:
  std::unique_ptr<Method> method_;
  Parameters parameters_;
  bool all_at_first_;
  std::size_t step_ = 0;
};

/// The hash of a run around two boxes: turns, narrow places and memory matter.
std::string run_of(std::unique_ptr<Method> method) {
  Primitives obstacles;
  obstacles.polygons = {{{{2, -1.5}, {2.5, -1.5}, {2.5, 0.8}, {2, 0.8}}},
                        {{{4, -0.8}, {4.5, -0.8}, {4.5, 1.5}, {4, 1.5}}}};
  const World world(Scenario::continuous("boxes", {-1, -2, 7, 2}, obstacles, {0, 0, 2}, {6, 0}),
                    0.05);
  RunSetup setup;
  setup.simulation.max_time = 15;
  const Trajectory trajectory = simulate(world, setup, 1, *method).trajectory;
  EXPECT_GT(trajectory.samples.size(), 30U);
  return trajectory.hash();
}

TEST(ChangedParameters, OfTheSameValueChangeNoRun) {
  for (const std::string name : kPlugins) {
    const Parameters parameters = defaults_of(name);
    ASSERT_FALSE(parameters.empty()) << name;
    EXPECT_EQ(run_of(std::make_unique<Setting>(create(name), parameters, false)),
              run_of(create(name)))
        << name;
  }
}

TEST(ChangedParameters, BeforeTheFirstStepAreAsIfTheMethodWereMadeWithThem) {
  for (const std::string name : kPlugins) {
    Parameters parameters;
    for (const TunableParameter& p : create(name)->tunable_parameters())
      parameters.emplace_back(p.name, format_number(p.integer ? p.low : 0.5 * (p.low + p.high)));
    const std::string changed = run_of(create(name, parameters));
    EXPECT_NE(changed, run_of(create(name))) << name;
    EXPECT_EQ(run_of(std::make_unique<Setting>(create(name), parameters, true)), changed) << name;
  }
}

TEST(ChangedParameters, ThatAreUnknownInvalidOrOfTheMapAreErrors) {
  const auto error_of = [](const std::string& plugin, const std::string& name,
                           const std::string& value) {
    const auto method = create(plugin);
    method->reset({});
    try {
      method->set_parameter(name, value);
      return std::string("was set");
    } catch (const MethodError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(error_of("dwa", "gama", "1"), "unknown parameter of dwa: 'gama'; expected 'gamma'");
  for (const auto& [name, value] :
       Parameters{{"gamma", "-1"}, {"gamma", "much"}, {"v_samples", "2.5"}, {"memory", "10"}})
    EXPECT_EQ(error_of("dwa", name, value),
              "dwa does not take " + name + " = " + value + " during a run");
}

}  // namespace
}  // namespace slalom
