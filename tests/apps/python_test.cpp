// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "program_run.h"

#include <nlohmann/json.hpp>

#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace slalom {
namespace {

using Json = nlohmann::json;

/// A method that moves to the goal, except for what `fault` says.
constexpr char kModule[] = R"(
import math, os, sys, threading, time

class Method:
    options = {"fault": ("none", "-", "")}

    def __init__(self, robot, options):
        self.robot, self.fault = robot, options.fault

    def reset(self, task):
        self.cycles = 0

    def step(self, o):
        self.cycles += 1
        if self.cycles == 5:
            getattr(self, self.fault)()
        w = max(-self.robot.max_w, min(self.robot.max_w, math.atan2(o.goal_y, o.goal_x)))
        return min(self.robot.max_v, 0.5), w

    def none(self): pass
    def error(self): raise RuntimeError("lost")
    def say(self): print("at", self.cycles, end=" of many\n")
    def kill(self): os.abort()
    def leave(self): os._exit(3)
    def hang(self):
        while True: pass
    def thread(self): threading.Thread(target=time.sleep, args=(60,), daemon=True).start()
    def package(self):
        import only_here
        raise RuntimeError(only_here.TEXT)
)";

class PythonProgramTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("method.py", kModule);
    std::string text = kSmallCampaign;
    text.replace(text.find("nd, gap"), 7, "gap, mine");
    write("small.ini",
          text + "[method.mine]\nadapter = python\nmodule = method.py\nclass = Method\n");
  }

  /// The records of the runs of method mine.
  std::vector<Json> runs(const std::string& fault, const std::string& arguments = "",
                         const std::string& environment = "") const {
    const ProgramResult result =
        run("env " + environment +
            " slalom-simulate run -c small.ini --overwrite -o runs.results --quiet " +
            "--set method.mine.fault=" + fault + " " + arguments);
    EXPECT_LE(result.status, 1) << result.err;
    std::istringstream lines(run("slalom-analyze dump runs.results").out);
    std::vector<Json> records;
    for (std::string line; std::getline(lines, line);)
      if (Json record = Json::parse(line); record.at("method") == "mine") records.push_back(record);
    EXPECT_EQ(records.size(), 4U);
    return records;
  }

  void expect_outcome(const std::string& outcome, const std::string& detail,
                      const std::vector<Json>& records) const {
    for (const Json& record : records) {
      EXPECT_EQ(record.at("outcome"), outcome) << record.dump();
      EXPECT_NE(record.dump().find(detail), std::string::npos) << record.dump();
    }
  }
};

TEST_F(PythonProgramTest, ResultsDoNotDependOnTheNumberOfWorkers) {
  runs("none", "-j 1");
  const std::string one = run("slalom-analyze dump runs.results").out;
  runs("none", "-j 2");
  EXPECT_EQ(run("slalom-analyze dump runs.results").out, one);
}

TEST_F(PythonProgramTest, AnExceptionEndsItsRunWithTheTraceback) {
  expect_outcome("method_error", "RuntimeError: lost (method.py:", runs("error"));
}

TEST_F(PythonProgramTest, WhatAMethodPrintsIsShownWithItsRun) {
  const auto shown = [this](const std::string& method) {
    return run("slalom-analyze show runs.results --run random_0000/" + method + "/0").out;
  };
  runs("say");
  const std::string heading = "printed by the method (not reproducible)\n";
  EXPECT_NE(shown("mine").find(heading + "  at 5 of many\n"), std::string::npos) << shown("mine");
  EXPECT_EQ(shown("gap").find(heading), std::string::npos);
  runs("error");
  EXPECT_NE(shown("mine").find("    def error(self): raise RuntimeError"), std::string::npos)
      << shown("mine");
}

TEST_F(PythonProgramTest, AnInterpreterThatCrashesOrExitsEndsItsRun) {
  expect_outcome("method_crash", "", runs("kill"));
  expect_outcome("method_crash", "status 3", runs("leave"));
}

TEST_F(PythonProgramTest, AnInterpreterThatHangsEndsItsRunAtTheDeadline) {
  expect_outcome("method_deadline", "", runs("hang", "-j 2 --set limits.run_wall_time=2"));
}

TEST_F(PythonProgramTest, AThreadThatGoesOnDoesNotChangeLaterRuns) {
  const auto expected = runs("none");
  EXPECT_EQ(runs("thread"), expected);
}

TEST_F(PythonProgramTest, WritesNothingToTheFolderOfTheModule) {
  runs("none");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "__pycache__"));
}

TEST_F(PythonProgramTest, PackagesOfAnActivatedEnvironmentCanBeImported) {
  ASSERT_EQ(run(PYTHON " -m venv --without-pip --system-site-packages env").status, 0);
  const ProgramResult packages = run(
      "env/bin/python3 -c 'import sysconfig; print(sysconfig.get_path(\"purelib\"), end=\"\")'");
  std::ofstream(std::filesystem::path(packages.out) / "only_here.py") << "TEXT = 'found'\n";
  expect_outcome("method_error", "RuntimeError: found",
                 runs("package", "", "VIRTUAL_ENV=" + (folder_ / "env").string()));
  expect_outcome("method_error", "ModuleNotFoundError", runs("package", "", "-u VIRTUAL_ENV"));
}

TEST_F(PythonProgramTest, AnEnvironmentOfAnotherVersionIsNotUsedAndNamedWhereAModuleIsMissing) {
  std::filesystem::create_directories(folder_ / "env/lib/python3.2/site-packages");
  const std::string environment = "VIRTUAL_ENV=" + (folder_ / "env").string();
  EXPECT_EQ(runs("none", "", environment), runs("none"));
  const auto printed = [this] {
    return run("slalom-analyze show runs.results --run random_0000/mine/0").out;
  };
  const auto records = runs("package", "", environment);
  EXPECT_NE(printed().find("/env, which was not used; expected an environment of Python 3."),
            std::string::npos);
  EXPECT_EQ(runs("package", "", "-u VIRTUAL_ENV CONDA_PREFIX=/opt/conda"), records)
      << "results do not depend on it";
  EXPECT_NE(printed().find("CONDA_PREFIX is /opt/conda, which was not used"), std::string::npos);
  std::ofstream(folder_ / "lacking.py") << "import only_elsewhere\n";
  const ProgramResult lacking =
      run("env CONDA_PREFIX=/opt/conda slalom-evaluate small.ini -o lacking --quiet "
          "--set method.mine.module=lacking.py");
  EXPECT_NE(lacking.err.find("not in Python 3."), std::string::npos) << lacking.err;
  EXPECT_NE(lacking.err.find("CONDA_PREFIX is /opt/conda"), std::string::npos) << lacking.err;
  // A folder like that of an environment is none if no environment is activated.
  ASSERT_EQ(
      run(PYTHON " -c 'import os, sys; os.makedirs(\"lib/python%d.%d\" % sys.version_info[:2])'")
          .status,
      0);
  const ProgramResult beside =
      run("env -u VIRTUAL_ENV slalom-evaluate small.ini -o lacking --quiet "
          "--set method.mine.module=lacking.py");
  EXPECT_NE(beside.err.find("not in Python 3."), std::string::npos) << beside.err;
  EXPECT_EQ(beside.err.find("(bin/python3)"), std::string::npos) << beside.err;
}

TEST_F(PythonProgramTest, AnotherModuleIsAnotherCampaign) {
  ASSERT_EQ(run("slalom-simulate run -c small.ini -o runs.results --quiet").status, 0);
  write("method.py", std::string(kModule) + "# changed\n");
  expect_failure("slalom-simulate run -c small.ini -o runs.results", 3, {"module of method.mine"});
}

TEST_F(PythonProgramTest, AMissingModuleStopsBeforeTheFirstRun) {
  expect_failure(
      "slalom-simulate run -c small.ini -o runs.results --set method.mine.module=none.py", 2,
      {"method.mine.module", "'none.py' not found"});
}

TEST_F(PythonProgramTest, TheExampleSetsParametersOfTheInnerMethod) {
  const std::string command = "slalom-simulate run -c '" + std::string(kSource) +
                              "/examples/adaptive_parameters/campaign.ini' --quiet --set "
                              "scenarios.count=2 --set metrics.enabled=success -o ";
  const auto hashes = [&](const std::string& name, const std::string& settings) {
    EXPECT_EQ(run(command + name + settings).status, 0);
    std::map<std::string, std::vector<std::string>> found;
    std::istringstream lines(run("slalom-analyze dump " + name).out);
    for (std::string line; std::getline(lines, line);) {
      const Json one = Json::parse(line);
      EXPECT_NE(one.at("outcome"), "method_error") << line;
      found[one.at("method")].push_back(one.at("trajectory_hash"));
    }
    return found;
  };
  auto found = hashes("a.results", "");
  EXPECT_NE(found.at("adaptive"), found.at("fixed"));
  // With the parameters of the inner method in all places it is that method.
  std::string same;
  for (const std::string place : {"open", "narrow"})
    for (const std::string value :
         {"sim_time_*=1.7", "occdist_scale_*=0.01", "inflation_radius_*=0.55"})
      same += " --set method.adaptive." + std::regex_replace(value, std::regex("\\*"), place);
  found = hashes("b.results", same);
  EXPECT_EQ(found.at("adaptive"), found.at("fixed"));
}

TEST_F(PythonProgramTest, TheExampleIsTheOneInTheDocuments) {
  const std::string source = kSource;
  const std::string document = read_text(source + "/docs/methods/methods.md");
  const std::string module = read_text(source + "/examples/python_method/my_method.py");
  std::string ini = read_text(source + "/examples/python_method/campaign.ini");
  ini.erase(0, ini.find('\n') + 1);  // the comment that says how to run it
  EXPECT_NE(document.find("```python my_method.py\n" + module + "```\n"), std::string::npos);
  EXPECT_NE(document.find("```ini python.ini\n" + ini + "```\n"), std::string::npos);
}

}  // namespace
}  // namespace slalom
