// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "temporary_folder.h"

#include <slalom/slalom.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <string>

namespace slalom {
namespace {

using Json = nlohmann::json;
using Scenarios = std::unique_ptr<slalom_scenarios, decltype(&slalom_scenarios_free)>;
using Results = std::unique_ptr<slalom_results, decltype(&slalom_results_free)>;

std::string taken(char* text) {
  if (text == nullptr) return std::string("failed: ") + slalom_error();
  const std::unique_ptr<char, decltype(&slalom_free)> owner(text, slalom_free);
  return text;
}

Scenarios generated(int count, const std::string& settings = "{}") {
  return {slalom_scenarios_generate("random", count, 1, 1, settings.c_str(), nullptr, nullptr),
          slalom_scenarios_free};
}

Results evaluated(const std::string& methods, const slalom_scenarios* scenarios,
                  const std::string& options = R"({"metrics": ["success"]})",
                  const slalom_own_methods* own = nullptr, slalom_progress progress = nullptr) {
  return {slalom_evaluate(methods.c_str(), own, scenarios, options.c_str(), progress, nullptr),
          slalom_results_free};
}

const std::string kGap =
    R"([{"name": "gap", "keys": {"adapter": "library", "plugin": "libslalom_follow_the_gap.so"}}])";

std::string error_of(const std::string& methods, const std::string& options,
                     const slalom_own_methods* own = nullptr) {
  const Scenarios scenarios = generated(1);
  return evaluated(methods, scenarios.get(), options, own) == nullptr ? slalom_error() : "none";
}

/// A method of this program, of which the type says what it does.
enum Type : std::uint64_t { Turns = 1, Refuses = 2, Fails = 3, SaysNothing = 4, Undescribed = 5 };
const slalom_own_methods kOwn = {
    [](std::uint64_t type, const char* options, const slalom_robot* robot) -> std::uint64_t {
      EXPECT_EQ(std::string(options), "{}");
      EXPECT_EQ(robot->rays, 181);
      slalom_reply(type == Refuses ? "it refuses"
                   : type == Undescribed
                       ? "{}"
                       : R"({"uses_tracks": false, "uses_map": false, "tunable": []})");
      return type == Refuses ? 0 : type;
    },
    [](std::uint64_t, const slalom_task* task, const double* heading, const slalom_map* map) {
      EXPECT_GT(task->control_period, 0);
      EXPECT_EQ(heading, nullptr);
      EXPECT_EQ(map, nullptr);
      return 0;
    },
    [](std::uint64_t method, const slalom_observation* o, const slalom_track*, std::size_t count,
       slalom_command* command) {
      EXPECT_EQ(o->rays, 181U);
      EXPECT_EQ(count, 0U);
      slalom_reply("it fails");
      if (method != SaysNothing) *command = {0, 0.5, 0};
      return method == Fails ? 1 : 0;
    },
    [](std::uint64_t, const char*) { return 0; },
    [](std::uint64_t) {},
    nullptr,
    nullptr};

TEST(CInterface, ScenariosAreMadeDescribedWrittenAndReadAgain) {
  const Scenarios made = generated(3);
  ASSERT_EQ(slalom_scenarios_size(made.get()), 3U) << slalom_error();
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  ASSERT_EQ(slalom_scenarios_write(made.get(), path.c_str()), 0) << slalom_error();
  const Scenarios read(slalom_scenarios_read(path.c_str()), slalom_scenarios_free);
  const Scenarios picked(slalom_scenarios_new(), slalom_scenarios_free);
  for (const std::size_t index : {2, 0})
    ASSERT_EQ(slalom_scenarios_add(picked.get(), read.get(), index), 0);
  EXPECT_EQ(taken(slalom_scenario_json(picked.get(), 0)),
            taken(slalom_scenario_json(made.get(), 2)));
  const Json described = Json::parse(taken(slalom_scenario_json(made.get(), 0)));
  const Scenarios copied(
      slalom_scenarios_from_yaml(taken(slalom_scenario_yaml(made.get(), 0)).c_str()),
      slalom_scenarios_free);
  EXPECT_EQ(Json::parse(taken(slalom_scenario_json(copied.get(), 0)))["hash"], described["hash"]);
  std::size_t rows = 0, columns = 0;
  const std::unique_ptr<std::uint8_t, decltype(&slalom_free)> cells(
      slalom_scenario_occupancy(made.get(), 0, 0.1, &rows, &columns), slalom_free);
  const auto cell = [&](const Json& place, std::size_t axis) {
    return static_cast<std::size_t>(
        (place[axis].get<double>() - described["bounds"][axis].get<double>()) / 0.1);
  };
  const Json& start = described["start"];
  EXPECT_EQ(cells.get()[cell(start, 1) * columns + cell(start, 0)], 0) << rows;
}

TEST(CInterface, ResultsAreThoseOfTheSameRunsInAFile) {
  const Scenarios scenarios = generated(3);
  const TemporaryFolder folder;
  const Json options = {{"metrics", {"success", "time_to_goal"}},
                        {"output", folder / "a.results"},
                        {"seed", 7},
                        {"workers", 2}};
  const Results made = evaluated(kGap, scenarios.get(), options.dump());
  ASSERT_NE(made, nullptr) << slalom_error();
  const Results read(slalom_results_read((folder / "a.results").c_str()), slalom_results_free);
  ASSERT_EQ(slalom_results_size(read.get()), 3U) << slalom_error();
  EXPECT_EQ(taken(slalom_results_summary(made.get())), taken(slalom_results_summary(read.get())));
  EXPECT_NE(taken(slalom_results_html(made.get())).find(">gap<"), std::string::npos);
  const Json described = Json::parse(taken(slalom_results_json(read.get())));
  EXPECT_EQ(described["manifest"]["campaign.seed"], "7");
  const std::unique_ptr<double, decltype(&slalom_free)> times(
      slalom_results_numbers(read.get(), "time_to_goal"), slalom_free);
  for (std::size_t run = 0; run < 3; ++run) {
    std::size_t samples = 0;
    const std::unique_ptr<double, decltype(&slalom_free)> trajectory(
        slalom_results_trajectory(made.get(), run, &samples), slalom_free);
    ASSERT_GT(samples, 1U) << slalom_error();
    if (described["columns"]["outcome"][run] == "success") {
      EXPECT_EQ(times.get()[run], trajectory.get()[(samples - 1) * 11]);
    } else {
      EXPECT_TRUE(std::isnan(times.get()[run]));
      EXPECT_NE(described["reasons"]["time_to_goal"][std::to_string(run)], "");
    }
  }
}

TEST(CInterface, AColumnOfTheProgramIsAddedToAFile) {
  const Scenarios scenarios = generated(2);
  const TemporaryFolder folder;
  const std::string options = Json({{"output", folder / "a.results"}}).dump();
  const Results made = evaluated(kGap, scenarios.get(), options);
  ASSERT_NE(made, nullptr) << slalom_error();
  const Scenarios theirs(slalom_results_scenarios(made.get()), slalom_scenarios_free);
  EXPECT_EQ(taken(slalom_scenario_yaml(theirs.get(), 1)),
            taken(slalom_scenario_yaml(scenarios.get(), 1)));
  Json column = {{"id", "comfort"}, {"of", "runs"},    {"values", {0.5, "no one sat in it"}},
                 {"version", 2},    {"unit", "-"},     {"better", "up"},
                 {"kind", "ratio"}, {"range", "0..1"}, {"source", "comfort.c"}};
  const auto add = [&] {
    return Results(
        slalom_results_add(made.get(), column.dump().c_str(), (folder / "b.results").c_str()),
        slalom_results_free);
  };
  const Results added = add();
  ASSERT_NE(added, nullptr) << slalom_error();
  const Json described = Json::parse(taken(slalom_results_json(added.get())));
  EXPECT_EQ(described["reasons"]["comfort"], Json({{"1", "no one sat in it"}}));
  EXPECT_EQ(described["manifest"]["own_column.comfort"], "comfort.c");
  column["values"] = {1};
  EXPECT_EQ(add(), nullptr);
  EXPECT_EQ(slalom_error(), std::string("comfort: has 1 value; expected 2, one per run"));
  column["of"] = "methods";
  EXPECT_EQ(add(), nullptr);
  EXPECT_EQ(slalom_error(), std::string("of: unknown 'methods'; expected runs or scenarios"));
  column["of"] = "runs";
  column["version"] = 1e30;
  EXPECT_EQ(add(), nullptr);
  EXPECT_EQ(slalom_error(),
            std::string("version: '1e+30' is not valid; expected an integer in [1, 1000000]"));
  column.erase("range");
  EXPECT_EQ(add(), nullptr);
  EXPECT_NE(std::string(slalom_error()).find("range"), std::string::npos);
}

TEST(CInterface, AFamilyOfTheProgramMakesScenarios) {
  const slalom_family field = [](void* context, const char* name, std::uint64_t seed) {
    ++*static_cast<int*>(context);
    const double x = 2 + static_cast<double>(seed % 1000) / 500;
    slalom_reply(Json({{"name", name},
                       {"representation", "continuous"},
                       {"bounds", {0, 0, 6, 4}},
                       {"start", {0.75, 2, 0}},
                       {"goal", {5.25, 2}},
                       {"discs", {{x, 2, 0.3}}},
                       {"polygons", Json::array()}})
                     .dump()
                     .c_str());
    return 0;
  };
  int calls = 0;
  const auto generate = [&](slalom_family family) {
    return Scenarios(slalom_scenarios_generate_own("field", family, 3, 1, 1, "{}", nullptr, &calls),
                     slalom_scenarios_free);
  };
  const Scenarios made = generate(field);
  ASSERT_EQ(slalom_scenarios_size(made.get()), 3U) << slalom_error();
  EXPECT_GE(calls, 3);
  EXPECT_EQ(Json::parse(taken(slalom_scenario_json(made.get(), 2)))["name"], "field_0002");
  EXPECT_EQ(generate(nullptr), nullptr);
  const auto refuses = [](void*, const char*, std::uint64_t) {
    slalom_reply("no room");
    return 1;
  };
  EXPECT_EQ(generate(refuses), nullptr);
  EXPECT_EQ(slalom_error(), std::string("family field: no room"));
}

TEST(CInterface, MethodsOfTheProgramRunInWorkersAndInProcess) {
  const Scenarios scenarios = generated(2);
  const std::string methods = R"([{"name": "fails", "type": 3}, {"name": "says nothing", "type": 4},
                                  {"name": "turns", "type": 1}])";
  for (const char* in_process : {"false", "true"}) {
    const std::string options = R"({"metrics": ["success"], "simulation": {}, "in_process": )";
    const Results results = evaluated(
        methods, scenarios.get(),
        std::string(R"({"metrics": ["success"], "in_process": )") + in_process + "}", &kOwn);
    ASSERT_NE(results, nullptr) << slalom_error();
    const Json columns = Json::parse(taken(slalom_results_json(results.get())))["columns"];
    const Json expected = {"method_error", "method_invalid_command", "stuck"};
    for (std::size_t run = 0; run < 6; ++run)
      EXPECT_EQ(columns["outcome"][run], expected[run % 3]) << columns;
    EXPECT_NE(columns["detail"][0].get<std::string>().find("it fails"), std::string::npos);
  }
}

TEST(CInterface, WhatCannotBeIsAnErrorWithItsReason) {
  const std::string own = R"([{"name": "a", "type": 1}])";
  slalom_own_methods incomplete = kOwn;
  incomplete.finish = nullptr;
  EXPECT_EQ(error_of(kGap, "{"), "options: is not JSON; expected see slalom.h");
  EXPECT_EQ(error_of(kGap, R"({"seeds": 1})"), "options: unknown key 'seeds'; expected 'seed'");
  EXPECT_NE(error_of(kGap, R"({"output": 1})").find("an argument is not as slalom.h says"),
            std::string::npos);
  for (const std::string number : {"-1", "0.5", "1e300", "\"x\"", "18446744073709551615"})
    EXPECT_EQ(error_of(kGap, "{\"seed\": " + number + "}").rfind("options seed: '", 0), 0U)
        << number;
  EXPECT_NE(error_of(kGap, R"({"workers": 4294967297})").find("[0, 1000]"), std::string::npos);
  EXPECT_NE(error_of("{}", "{}").find("methods: none given"), std::string::npos);
  EXPECT_NE(error_of(R"([{"keys": {}}])", "{}").find("'name' not found"), std::string::npos);
  EXPECT_NE(error_of(kGap, R"({"settings": {"robot": {"raduis": "1"}}})").find("'radius'"),
            std::string::npos);
  EXPECT_EQ(error_of(kGap, R"({"settings": {"robots": {"radius": "1"}}})"),
            "robots.radius: [robots]: unknown section; expected [robot]");
  EXPECT_EQ(error_of(kGap, R"({"settings": []})"),
            "settings: are no object; expected {SECTION: {...}}");
  for (const slalom_own_methods* functions : {static_cast<const slalom_own_methods*>(nullptr),
                                              static_cast<const slalom_own_methods*>(&incomplete)})
    EXPECT_EQ(error_of(own, "{}", functions),
              "method 'a': has a type; expected all functions of slalom_own_methods");
  EXPECT_EQ(error_of(R"([{"name": "a", "type": 2}])", "{}", &kOwn), "method 'a': it refuses");
  EXPECT_EQ(error_of(R"([{"name": "a", "type": 5}])", "{}", &kOwn),
            "method 'a': is described by '{}'; expected see slalom_own_methods");
}

TEST(CInterface, NullPointersAndPlacesBeyondTheEndAreErrors) {
  const Scenarios scenarios = generated(1);
  const Results results = evaluated(kGap, scenarios.get());
  ASSERT_NE(results, nullptr) << slalom_error();
  std::size_t number = 0;
  EXPECT_EQ(taken(slalom_scenario_json(scenarios.get(), 1)),
            "failed: scenario 1: is not in the list; expected less than 1");
  EXPECT_EQ(taken(slalom_scenario_svg(nullptr, 0)),
            "failed: scenarios: are a null pointer; expected a list");
  EXPECT_EQ(slalom_scenario_occupancy(scenarios.get(), 0, 0.1, nullptr, &number), nullptr);
  EXPECT_EQ(slalom_scenario_occupancy(scenarios.get(), 0, std::nan(""), &number, &number), nullptr);
  EXPECT_EQ(slalom_scenario_occupancy(scenarios.get(), 0, 1e-9, &number, &number), nullptr);
  EXPECT_EQ(slalom_scenarios_generate(nullptr, 1, 1, 1, "{}", nullptr, nullptr), nullptr);
  EXPECT_EQ(slalom_scenarios_generate("random", -1, 1, 1, "{}", nullptr, nullptr), nullptr);
  EXPECT_EQ(slalom_scenarios_read(nullptr), nullptr);
  EXPECT_EQ(slalom_scenarios_write(scenarios.get(), nullptr), -1);
  EXPECT_EQ(slalom_scenarios_add(scenarios.get(), scenarios.get(), 1), -1);
  EXPECT_EQ(slalom_results_read("/nonexistent.results"), nullptr);
  EXPECT_EQ(slalom_results_numbers(results.get(), "sucess"), nullptr);
  EXPECT_EQ(slalom_results_trajectory(results.get(), 1, &number), nullptr);
  EXPECT_EQ(slalom_results_trajectory(results.get(), 0, &number), nullptr) << "in no file";
  EXPECT_EQ(slalom_results_save(results.get(), "a.results"), -1);
  EXPECT_EQ(slalom_error(),
            std::string("results: are in no file; expected an output of slalom_evaluate()"));
  EXPECT_EQ(slalom_results_summary(nullptr), nullptr);
  EXPECT_EQ(slalom_certify("risk", "{}", "{}", nullptr, "[]", 1, nullptr), nullptr);
  EXPECT_EQ(slalom_scenarios_size(nullptr), 0U);
  EXPECT_EQ(slalom_results_size(nullptr), 0U);
  slalom_free(nullptr);
  slalom_results_free(nullptr);
  slalom_scenarios_free(nullptr);
}

TEST(CInterface, AProgressFunctionEndsAJob) {
  const slalom_progress stop = [](void*, const char*, std::size_t, std::size_t) { return 1; };
  EXPECT_EQ(slalom_scenarios_generate("random", 2, 1, 2, "{}", stop, nullptr), nullptr);
  EXPECT_EQ(std::string(slalom_error()), "interrupted");
  const Scenarios scenarios = generated(1);
  EXPECT_EQ(evaluated(kGap, scenarios.get(), "{}", nullptr, stop), nullptr);
  EXPECT_EQ(std::string(slalom_error()), "interrupted");
}

TEST(CInterface, WhatTheHostRaisesIsPutAsideUntilTheFunctionReturns) {
  static std::string told;
  slalom_host host = {};
  host.interrupted = [] { return -1; };
  host.put_aside = [](void** first, void**, void**) {
    told += "aside ";
    *first = &told;
  };
  host.raise_again = [](void* first, void* second, void*) {
    told += first == &told && second == nullptr ? "again" : "another";
  };
  const Scenarios scenarios = generated(1);
  slalom_set_host(&host);
  EXPECT_EQ(evaluated(kGap, scenarios.get()), nullptr);
  slalom_set_host(nullptr);
  EXPECT_EQ(told, "aside again");
  EXPECT_NE(evaluated(kGap, scenarios.get()), nullptr) << slalom_error();
}

TEST(CInterface, AQuestionIsAnsweredAsByTheProgram) {
  const Json answer = Json::parse(
      taken(slalom_certify("risk", R"({"method": "gap", "at_most": 0.5, "budget": 100})",
                           Json::parse(kGap)[0].dump().c_str(), nullptr,
                           R"({"scenarios": {"generator": "random"}})", 1, "")));
  EXPECT_EQ(answer["certificate"]["question"]["method"], "gap");
  EXPECT_NE(answer["text"], "");
}

}  // namespace
}  // namespace slalom
