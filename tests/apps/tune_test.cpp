// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "program_run.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>

namespace slalom {
namespace {

using Json = nlohmann::json;

/// The method of plugins/planted_optimum.c, as a class in Python.
constexpr char kPlanted[] =
    "import math\n"
    "class Planted:\n"
    "    options = {'a': (0.1, '-', 'planted'), 'b': (3, '-', 'without effect')}\n"
    "    option_ranges = {'a': (0, 1), 'b': (1, 9)}\n"
    "    def __init__(self, robot, options): self.drives = abs(options.a - 0.7) < 0.2\n"
    "    def reset(self, task): pass\n"
    "    def step(self, o):\n"
    "        if not self.drives: return 0, 0\n"
    "        return 1, max(-1, min(1, math.atan2(o.goal_y, o.goal_x)))\n";
/// Small scenarios without obstacles.
const std::string kIni =
    "[campaign]\nmethods = planted\n[scenarios]\ngenerator = random\n"
    "[generator.random]\nmin_obstacles = 0\nmax_obstacles = 0\n"
    "width = 5\nheight = 5\nmin_distance = 2\n"
    "[simulation]\nstuck_time = 1\n"
    "[method.planted]\nadapter = library\nplugin = " +
    kBuild +
    "/tests/apps/plugins/libplanted_optimum.so\n"
    "[method.snake]\nadapter = python\nmodule = planted.py\nclass = Planted\n"
    "[method.go]\nadapter = library\nplugin = libslalom_go_to_goal.so\n";

class Tune : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("planted.py", kPlanted);
    write("my.ini", kIni);
  }
  Json answer(const std::string& folder) const {
    return Json::parse(read(folder + "/tuned.json")).at("answer");
  }
};

constexpr char kTune[] = "slalom-tune my.ini --quiet --runs 300 --sealed 200 ";

TEST_F(Tune, AndTheOtherCommandsThatAReportProposesRunAsTheyAreTyped) {
  std::string ini = kIni;
  ini.replace(ini.find("methods = planted"), 17, "methods = planted, zgo");
  ini.replace(ini.find("generator = random"), 18, "generator = random\ncount = 12");
  write("two.ini", ini + "[method.zgo]\nadapter = library\nplugin = libslalom_go_to_goal.so\n");
  std::filesystem::rename(folder_ / "two.ini", folder_ / "two methods.ini");
  ASSERT_EQ(
      run("slalom-evaluate 'two methods.ini' --set method.planted.a=0.7 -o out/ --quiet").status,
      0);
  const std::string page = read("out/report/index.html");
  const std::regex pattern("<code class=\"command\">([^<]*)</code>");
  std::vector<std::string> programs;
  for (std::sregex_iterator at(page.begin(), page.end(), pattern), end; at != end; ++at) {
    std::string command = (*at)[1];
    for (std::size_t quote; (quote = command.find("&#39;")) != std::string::npos;)
      command.replace(quote, 5, "'");
    ASSERT_EQ(command.find('&'), std::string::npos) << "of HTML: " << command;
    EXPECT_NE(command.find(" 'two methods.ini' --set method.planted.a=0.7 "), std::string::npos);
    EXPECT_NE(command.find(" -o out-"), std::string::npos) << command;
    const ProgramResult result = run(command);
    EXPECT_EQ(result.status, 0) << command << "\n" << result.err;
    programs.push_back(command.substr(0, command.find(' ')));
  }
  EXPECT_EQ(programs,
            (std::vector<std::string>{"slalom-evaluate", "slalom-falsify", "slalom-tune"}));
}

TEST_F(Tune, FindsAPlantedOptimumAndShowsThatItIsBetter) {
  const ProgramResult result = run(std::string(kTune) + "--method planted --require -o out");
  ASSERT_EQ(result.status, 0) << result.err;
  const Json found = answer("out");
  EXPECT_EQ(found.at("verdict"), "better");
  EXPECT_NEAR(std::stod(found.at("recommendation").at("a").get<std::string>()), 0.7, 0.2);
  const std::string b = found.at("winner").at("b");
  EXPECT_EQ(b.find('.'), std::string::npos) << "an integer, as its default: " << b;
  EXPECT_EQ(found.at("default"), Json({{"a", "0.1"}, {"b", "3"}}));
  // The default succeeds never, the winner always.
  EXPECT_EQ(found.at("sealed").at("difference").at("value"), 1);
  EXPECT_EQ(found.at("sealed").at("default_counts").at("successes"), 0);
  EXPECT_TRUE(found.at("sealed").at("hard_end").is_null()) << "all scenarios have density 0";
  EXPECT_LE(found.at("search_runs"), 300);
  // Whatever is not told apart from the winner drives, too; b may have any of several values.
  const Json& equal = found.at("not_told_apart").at("options");
  EXPECT_GT(std::stod(equal.at("a").at("low").get<std::string>()), 0.5);
  EXPECT_LT(std::stod(equal.at("a").at("high").get<std::string>()), 0.9);
  EXPECT_NE(equal.at("b").at("low"), equal.at("b").at("high"));
  EXPECT_NE(result.out.find("claim: better, by 1.00 ["), std::string::npos) << result.out;
  // No collision in 200 runs does not exclude 1 - 0.05^(1/200) = 0.0149.
  const Json& collisions = found.at("sealed").at("tuned_collisions");
  EXPECT_EQ(collisions.at("value"), 0);
  EXPECT_GT(collisions.at("high"), 0.0149);
  EXPECT_LT(collisions.at("high"), 0.05);
  const std::string bound = "collisions of the winner: at most ";
  const std::size_t printed = result.out.find(bound);
  ASSERT_NE(printed, std::string::npos);
  EXPECT_GE(std::stod(result.out.substr(printed + bound.size())), collisions.at("high"))
      << "rounded up";

  // The campaign with these options, and the same answer from any number of workers.
  const ProgramResult tuned =
      run("slalom-simulate run out/tuned.ini --quiet --set scenarios.count=3 "
          "-o a.results");
  EXPECT_EQ(tuned.status, 0) << tuned.err;
  const ProgramResult dump = run("slalom-analyze dump a.results");
  EXPECT_EQ(dump.out.find(R"("outcome":"stuck")"), std::string::npos);
  EXPECT_EQ(run("slalom-scenarios generate -c out/tuned.ini -n 2 -o two.scenarios --quiet").status,
            0);
  const ProgramResult verified = run("slalom-certify verify out/tuned.json --trust --quiet -j 3");
  EXPECT_EQ(verified.status, 0) << verified.err;
  const std::string page = read("out/tuned.html");
  EXPECT_NE(page.find("main effects"), std::string::npos);
  EXPECT_LT(page.find("class=\"answer\">claim: "), page.find("<table>")) << "the answer first";
}

TEST_F(Tune, SearchesThatShareSealedScenariosAreCounted) {
  const auto tune = [&](const std::string& more) {
    const ProgramResult result =
        run("slalom-tune my.ini --quiet --runs 300 --method planted " + more);
    EXPECT_EQ(result.status, 0) << result.err;
    return result.out;
  };
  const std::string shared = " sealed scenarios that ";
  EXPECT_EQ(tune("--sealed 200 -o all/a").find(shared), std::string::npos);
  // The sets of another size begin with the same scenarios.
  EXPECT_NE(tune("--sealed 201 -o all/b").find("of 200" + shared + "1 other search"),
            std::string::npos);
  // Parts of a list overlap: two times 200 of 400.
  const std::string least = "--development 100 --finals 100 --sealed 200 ";
  ASSERT_EQ(
      run("slalom-scenarios generate -c my.ini -n 400 --seed 7 -o l.scenarios --quiet").status, 0);
  const std::string list = "--set scenarios.list=l.scenarios --set scenarios.generator= " + least;
  EXPECT_EQ(tune(list + "-o lists/a").find(shared), std::string::npos);
  EXPECT_NE(tune(list + "--seed 2 -o lists/b").find(shared + "1 other search"), std::string::npos);
}

TEST_F(Tune, ShowsTheScenariosInWhichTheDefaultIsWorse) {
  // The default stands still where it sees an obstacle; half of the scenarios have one.
  write("planted.py",
        "import math\n"
        "class Planted:\n"
        "    options = {'a': (0.1, '-', 'planted')}\n"
        "    option_ranges = {'a': (0, 1)}\n"
        "    def __init__(self, robot, options): self.a = options.a\n"
        "    def reset(self, task): self.drives = None\n"
        "    def step(self, o):\n"
        "        steps = [abs(a - b) for a, b in zip(o.ranges, o.ranges[1:])]\n"
        "        if self.drives is None: self.drives = self.a > 0.5 or max(steps) < 0.6\n"
        "        if not self.drives: return 0, 0\n"
        "        return 1, max(-1, min(1, math.atan2(o.goal_y, o.goal_x)))\n");
  const ProgramResult result =
      run(std::string(kTune) +
          "--method snake --set generator.random.max_obstacles=1 "
          "--set generator.random.width=12 --set generator.random.height=12 "
          "--set generator.random.min_distance=8 --stratify obstacle_count -o out");
  ASSERT_EQ(result.status, 0) << result.err;
  const Json sealed = answer("out").at("sealed");
  const Json& hard = sealed.at("hard_end");
  EXPECT_EQ(hard.at("condition"), "obstacle_count >= 1");
  // 100 of 200, with a standard deviation of 7.
  EXPECT_NEAR(hard.at("tuned_counts").at("runs").get<double>(), 100, 35);
  // The default succeeds where there is none, and where the obstacle is out of sight.
  EXPECT_LT(hard.at("default").at("high"), sealed.at("default").at("low"));
  EXPECT_GT(hard.at("tuned").at("low"), hard.at("default").at("high"));
  EXPECT_NE(result.out.find("  of these obstacle_count >= 1  "), std::string::npos) << result.out;
}

TEST_F(Tune, TunesKeysOfTheConfigurationOfAnMrptClass) {
  write("nd.ini",
        "[campaign]\nmethods = nd\n[scenarios]\ngenerator = random\n"
        "[generator.random]\nmin_obstacles = 0\nmax_obstacles = 0\n"
        "[method.nd]\nadapter = mrpt_holonomic\nclass = CHolonomicND\n"
        "[tune]\nCHolonomicND.TOO_CLOSE_OBSTACLE = 0.02, 0.4, log\n"
        "sectors = 61, 241, integer\n");
  const std::string tune = "slalom-tune nd.ini --method nd --quiet --runs 300 --sealed 200 ";
  const ProgramResult result = run(tune + "-o out");
  ASSERT_EQ(result.status, 0) << result.err;
  // The default of the class, which has no .ini here.
  EXPECT_EQ(answer("out").at("default").at("CHolonomicND.TOO_CLOSE_OBSTACLE"), "0.15");
  EXPECT_NE(read("out/tuned.ini").find("config_set = CHolonomicND.TOO_CLOSE_OBSTACLE=0."),
            std::string::npos);
  EXPECT_EQ(run("slalom-certify verify out/tuned.json --trust --quiet").status, 0);
  expect_failure(tune + "--set tune.CHolonomicND.TOO_CLOSE_OBSTACLE=0.2,0.4 -o range", 2,
                 {"--set tune.CHolonomicND.TOO_CLOSE_OBSTACLE: invalid default 0.15"});
  const std::string set = "--set 'method.nd.config_set=CHolonomicND.TOO_CLOSE_OBSTACLE=0.2' ";
  ASSERT_EQ(run(tune + set + "-o other").status, 0);
  EXPECT_EQ(answer("other").at("default").at("CHolonomicND.TOO_CLOSE_OBSTACLE"), "0.2");

  write("bad.ini", read("nd.ini") + "CHolonomicND.TOO_CLOSE = 0, 1\n");
  const std::string bad = "slalom-tune bad.ini --method nd --quiet -o bad ";
  expect_failure(bad, 2, {"[tune] CHolonomicND.TOO_CLOSE: its default is unknown", "config_set"});
  expect_failure(bad + "--set method.nd.config_set=CHolonomicND.TOO_CLOSE=0", 2,
                 {"nobody reads TOO_CLOSE in [CHolonomicND]"});
  expect_failure(
      "slalom-tune bad.ini --method go --quiet -o bad --set method.go.adapter=library "
      "--set method.go.plugin=libslalom_go_to_goal.so",
      2, {"is not an option of [method.go]", "mrpt_holonomic and mrpt_navigator"});
}

TEST_F(Tune, AFolderKeepsTheResultOfOneSearch) {
  const std::string tune = std::string(kTune) + "--method go -o out ";
  ASSERT_EQ(run(tune).status, 0);
  const std::string first = read("out/tuned.json");
  EXPECT_EQ(run(tune + "-j 2").status, 0);
  expect_failure(tune + "--effect 0.2", 2, {"out/tuned.json: is the result of another search"});
  expect_failure(tune + "--set robot.max_v=0.9", 2, {"is the result of another search"});
  EXPECT_EQ(read("out/tuned.json"), first);
  write("out/tuned.json", "{}");
  expect_failure(tune, 3, {"out/tuned.json: ", "expected a certificate"});
  EXPECT_EQ(read("out/tuned.json"), "{}");
}

TEST_F(Tune, KeepsTheDefaultWhereNoOptionMatters) {
  const std::string null_ = std::string(kTune) + "--method planted --set tune.b=1,9,integer ";
  const ProgramResult result = run(null_ + "--set method.planted.a=0.7 -o out");
  ASSERT_EQ(result.status, 0) << result.err;
  const Json found = answer("out");
  EXPECT_EQ(found.at("verdict"), "not shown");
  EXPECT_EQ(found.at("recommendation"), found.at("default"));
  EXPECT_EQ(found.at("recommendation"), Json({{"b", "3"}}));
  EXPECT_EQ(result.out.find("front"), std::string::npos);
  const ProgramResult front = run(null_ + "--set method.planted.a=0.7 --front -o front");
  EXPECT_NE(front.out.find("front: finalists that no other one beats in both success and time"),
            std::string::npos)
      << front.out;
  // All arrive in the same time.
  const Json all = answer("front").at("front");
  ASSERT_GE(all.size(), 2U);
  for (const Json& one : all) EXPECT_EQ(one.at("minus_winner"), 0);
  EXPECT_EQ(all.at(0).at("common_successes"), all.at(0).at("finals").at("runs"));
  expect_failure(null_ + "--set method.planted.a=0.7 --require -o out2", 1,
                 {"--require: ", "not shown"});
}

TEST_F(Tune, AValueThatTheMethodRefusesIsToldBeforeTheSearch) {
  const std::string base = "slalom-tune my.ini --quiet -o out --method ";
  // The range of the option is [0.1, pi].
  expect_failure(
      base + "go --set method.go.turn_in_place=1 --set tune.turn_in_place=0.2,4", 2,
      {"--set tune.turn_in_place = 0.2, 4: go refuses 4: ", "turn_in_place: '4' is not valid"});
  write("planted.py", std::string(kPlanted) +
                          "    def __init__(self, robot, options):\n"
                          "        if options.b < 2: raise ValueError('b is too small')\n");
  expect_failure(base + "snake", 2,
                 {"[method.snake] b = 1, 9: snake refuses 1: ", "b is too small"});
  expect_failure(base + "snake --set method.snake.b=3 --set 'tune.b=3 | 1 | 4'", 2,
                 {"--set tune.b = 3 | 1 | 4: snake refuses 1: ", "b is too small"});
}

TEST_F(Tune, RefusesSearchesThatCannotBegin) {
  const std::string base = "slalom-tune my.ini --quiet -o out ";
  const std::pair<std::string, std::vector<std::string>> kRefused[] = {
      {"--method plantd", {"--method plantd", "'planted'"}},
      {"--method planted --runs 100", {"--runs: 100", "300"}},
      {"--method planted --sealed 100", {"--sealed: 100", "200 to 1000"}},
      {"--method planted --development 10", {"--development: 10", "100"}},
      {"--method planted --stratify densiti", {"densiti", "density"}},
      {"--method planted --then time", {"time"}},
      {"--method planted --confidence 1", {"--confidence 1"}},
      {"--method go --then safety", {"--then safety", "needs no safest path"}},
      {"--method go --set method.go.turn_in_place=x", {"turn_in_place"}},
      {"--method planted --set tune.a=1,0", {"tune.a"}},
      {"--method planted --set tune.a=0.5,1", {"tune.a", "default"}},
      {"--method planted --set tune.a=0,1,lin", {"'lin' is unknown", "LOW, HIGH"}},
      {"--method planted --set tune.a=much", {"'much' is not a range"}},
      {"--method planted --set tune.c=0,1", {"tune.c", "its default is unknown"}},
      {"--method planted --set tune.mode=\"x|y\"", {"no choice is the default"}},
      {"--method snake --set method.snake.module=plain.py", {"declares no ranges", "[tune]"}}};
  write("plain.py", std::string(kPlanted) + "    option_ranges = {}\n");
  for (const auto& [options, words] : kRefused) expect_failure(base + options, 2, words);
  write("bad.py", std::string(kPlanted) + "    option_ranges = {'a': 1}\n");
  expect_failure(base + "--method snake --set method.snake.module=bad.py", 2,
                 {"malformed range of 'a' in option_ranges"});
}

}  // namespace
}  // namespace slalom
