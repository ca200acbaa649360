// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "places.h"

#include <slalom/python/python_method.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <thread>

namespace slalom {
namespace {

const std::string kModules = kSource + "/tests/adapters/methods/python/modules";
constexpr double kPi = 3.14159265358979323846;

/// Line 3 contains the module, line 4 the class, further keys start at line 5.
std::string section_for(const std::string& module, const std::string& name,
                        const std::string& keys = "") {
  return "[method.a]\nadapter = python\nmodule = " + module + "\nclass = " + name + "\n" + keys;
}

std::unique_ptr<Method> load(const std::string& ini_text, const RobotModel& robot = {},
                             const SensorModel& sensor = {}) {
  const IniFile ini = IniFile::from_text(ini_text, kModules + "/campaign.ini");
  return read_python_method(ini, "method.a")(robot, sensor);
}

testing::AssertionResult refuses(const std::string& ini_text, const std::string& where,
                                 std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, kModules + "/campaign.ini:" + where, words,
                      [&] { load(ini_text); });
}

std::unique_ptr<Method> load_echo(const std::string& answer, const std::string& keys = "",
                                  const RobotModel& robot = {}) {
  SensorModel sensor;
  sensor.rays = 3;
  sensor.aperture_deg = 90;
  sensor.max_range = 6;
  auto method =
      load(section_for("echo.py", "Echo", "answer = " + answer + "\n" + keys), robot, sensor);
  NavigationTask task;
  task.start = {1.5, 2.5, 0.5};
  task.goal = {7, -8};
  task.goal_tolerance = 0.25;
  task.control_period = 0.125;
  task.seed = 12345;
  task.goal_heading = -0.75;
  task.goal_heading_tolerance = 0.125;
  method->reset(task);
  return method;
}

std::vector<double> step(Method& method, const std::vector<float>& ranges = {1, 2, 4},
                         const std::vector<Track>* tracks = nullptr) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.resizeScan(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) scan.setScanRange(i, ranges[i]);
  Observation observation;
  observation.time = 12.5;
  observation.odometry = {1, 2, 0.25};
  observation.v = 0.5;
  observation.w = -0.75;
  observation.vy = 0.0625;
  observation.goal_in_robot = {3, -4};
  observation.scan = &scan;
  observation.tracks = tracks;
  const Command command = method.step(observation);
  return {command.v, command.w, command.vy};
}

std::vector<double> echo(const std::string& answer, const std::string& keys = "",
                         const RobotModel& robot = {}) {
  return step(*load_echo(answer, keys, robot));
}

/// Text of the MethodError of one step.
std::string error_of(const std::string& answer) {
  try {
    echo(answer);
  } catch (const MethodError& error) {
    return error.what();
  }
  return "no error";
}

using Values = std::vector<double>;

TEST(PythonMethod, IsGivenTheObservation) {
  EXPECT_EQ(echo("time"), (Values{12.5, 0.25, 0}));
  EXPECT_EQ(echo("pose"), (Values{1, 2, 0}));
  EXPECT_EQ(echo("velocity"), (Values{0.5, -0.75, 0.0625}));
  EXPECT_EQ(echo("goal"), (Values{3, -4, 0}));
  EXPECT_EQ(echo("ranges"), (Values{1, 4, 3}));
}

TEST(PythonMethod, IsGivenTracksIfItsClassDeclaresThem) {
  EXPECT_FALSE(load_echo("time")->uses_tracks());
  const auto method = load(section_for("echo.py", "Tracker"));
  EXPECT_TRUE(method->uses_tracks());
  method->reset({});
  const std::vector<Track> tracks = {{1, {}, {}, 0.1}, {4, {1, 2}, {3, 4}, 0.5}};
  EXPECT_EQ(step(*method, {1, 2, 4}, &tracks), (Values{6, 21, 93}));
  EXPECT_THROW(step(*method), MethodError) << "a scan without tracks";
}

TEST(PythonMethod, IsGivenTheMapIfItsClassDeclaresIt) {
  EXPECT_FALSE(load_echo("time")->uses_map());
  const auto method = load(section_for("echo.py", "Mapper"));
  EXPECT_TRUE(method->uses_map());
  EXPECT_THROW(method->reset({}), MethodError) << "a task without a map";
  NavigationTask task;
  {
    const std::vector<std::uint8_t> cells = {0, 0, 0, 0, 0, 1};
    const KnownMap map = {0.5, {-1, 2}, 3, 2, &cells};
    task.map = &map;
    method->reset(task);
  }
  EXPECT_EQ(step(*method, {1, 2, 4}), (Values{132, 0.5, 2})) << "a copy, which is kept";
}

TEST(PythonMethod, IsGivenTheTask) {
  EXPECT_EQ(echo("start"), (Values{1.5, 2.5, 0.5}));
  EXPECT_EQ(echo("task"), (Values{7, -8, 0.25}));
  EXPECT_EQ(echo("period"), (Values{0.125, 12345, 0}));
}

TEST(PythonMethod, IsGivenTheRobotAndItsSensor) {
  RobotModel robot;
  robot.radius = 0.375;
  robot.max_v = 1.25;
  robot.max_w = 2.5;
  robot.max_accel_v = 0.5;
  robot.max_accel_w = 4.5;
  EXPECT_EQ(echo("limits", "", robot), (Values{1.25, 2.5, 0.375}));
  EXPECT_EQ(echo("accelerations", "", robot), (Values{0.5, 4.5, 0}));
  EXPECT_EQ(echo("sensor", "", robot), (Values{3, kPi / 2, 6}));
  EXPECT_EQ(echo("shape", "", robot), (Values{0, 0, 1}));
  robot.footprint = "0.3,0.2; -0.3,0.2; -0.3,-0.2; 0.3,-0.2";
  robot.kinematics = Kinematics::Holonomic;
  robot.forward_only = false;
  EXPECT_EQ(echo("shape", "", robot), (Values{4, 1, 0}));
  const auto corners = robot.shape().corners();
  EXPECT_EQ(echo("corner", "", robot), (Values{corners[0].x, corners[0].y, 0}));
  robot.footprint = "0.3,0.2; 0.1,0; 0.3,-0.2; -0.3,-0.2; -0.3,0.2";
  EXPECT_EQ(echo("shape", "", robot)[0], 4) << "the convex hull";
}

TEST(PythonMethod, SeesRangesAsFloatsThatItCannotWrite) {
  EXPECT_EQ(echo("dtype"), (Values{1, 0, 0}));
  EXPECT_NE(error_of("write").find("ValueError"), std::string::npos) << error_of("write");
}

TEST(PythonMethod, FollowsAChangingNumberOfRays) {
  const auto method = load_echo("ranges");
  EXPECT_EQ(step(*method, {1, 2, 4}), (Values{1, 4, 3}));
  EXPECT_EQ(step(*method, {5, 6}), (Values{5, 6, 2}));
  EXPECT_EQ(step(*method, {7, 8}), (Values{7, 8, 2}));
}

TEST(PythonMethod, TakesOptionsOfTheTypeOfTheirDefaults) {
  EXPECT_EQ(echo("options"), (Values{1.5, 3, 0}));
  EXPECT_EQ(echo("options", "gain = 2\ncount = 7\nenabled = true\n"), (Values{2, 7, 1}));
}

TEST(PythonMethod, MayReturnAnySequenceOfTwoOrThreeNumbers) {
  EXPECT_EQ(echo("list"), (Values{0.5, 0.25, 0}));
  for (const std::string answer : {"one", "four", "none", "text", "words"})
    EXPECT_NE(error_of(answer).find("; expected (v, w) or (v, w, vy)"), std::string::npos)
        << error_of(answer);
  EXPECT_EQ(error_of("one"), "step() returned (1.0,); expected (v, w) or (v, w, vy)");
}

TEST(PythonMethod, ImportsModulesOfItsFolder) {
  EXPECT_EQ(echo("helper"), (Values{0.125, 0.5, 0}));
}

TEST(PythonMethod, ReportsAnExceptionWithItsTracebackOnOneLine) {
  const std::string text = error_of("raise");
  EXPECT_EQ(text.find("KeyError: 'no such\\nplan' (echo.py:"), 0u) << text;
  EXPECT_NE(text.find("helper.py:7 in fail)"), std::string::npos) << text;
}

TEST(PythonMethod, DoesNotEndTheProcessByExit) {
  EXPECT_EQ(error_of("exit").find("SystemExit: 3"), 0u) << error_of("exit");
}

TEST(PythonMethod, GoesOnAfterAnException) {
  const auto method = load_echo("raise");
  EXPECT_THROW(step(*method), MethodError);
  EXPECT_EQ(echo("list"), (Values{0.5, 0.25, 0}));
}

TEST(PythonMethod, HashesTextsAsPythonDoesForTheSeedZero) {
  FILE* const pipe = popen("PYTHONHASHSEED=0 " PYTHON
                           " -c 'print(hash(\"slalom\") % 1000, hash(\"words\") % 1000)'",
                           "r");
  double first = -1, second = -1;
  ASSERT_EQ(fscanf(pipe, "%lf %lf", &first, &second), 2);
  pclose(pipe);
  EXPECT_EQ(echo("hash"), (Values{first, second, 0}));
}

TEST(PythonMethod, CanBeCalledByAnyThread) {
  const auto method = load_echo("list");
  Values command;
  std::thread([&] { command = step(*method); }).join();
  EXPECT_EQ(command, (Values{0.5, 0.25, 0}));
}

TEST(PythonMethod, NeedsNoMoreThanStep) {
  RobotModel robot;
  robot.max_v = 0.75;
  const auto method = load(section_for("echo.py", "OnlyStep", "turn = 0.5\n"), robot);
  const Values first = {0.75, 0.5, 0}, second = {0.75, 1, 0};
  for (int run = 0; run < 2; ++run) {
    method->reset({});  // forgets the steps of the run before
    EXPECT_EQ(step(*method), first);
    EXPECT_EQ(step(*method), second);
  }
}

/// Parameters that adapt() of a class gives where the goal is 3 m ahead.
std::map<std::string, std::string> adapted(const std::string& name, const std::string& keys = "") {
  const auto method = load(section_for("parameters.py", name, "inner = b\n" + keys));
  EXPECT_TRUE(method->adapts());
  method->reset({});
  mrpt::obs::CObservation2DRangeScan scan;
  Observation observation;
  observation.goal_in_robot = {3, 0};
  observation.scan = &scan;
  return method->adapt(observation);
}

TEST(PythonMethod, AdaptsByWhatItReturns) {
  using Texts = std::map<std::string, std::string>;
  EXPECT_EQ(adapted("Tuner"),
            (Texts{{"gain", "0.75"}, {"count", "3"}, {"fast", "true"}, {"mode", "b"}}));
  EXPECT_EQ(adapted("Tuner", "factor = 2\n").at("gain"), "6");
  try {
    adapted("NoParameters");
    FAIL() << "is taken";
  } catch (const MethodError& error) {
    EXPECT_TRUE(mentions(error.what(), {"adapt() returned 0.5", "a dict of parameters"}));
  }
  EXPECT_TRUE(refuses(section_for("parameters.py", "Gain", "inner = b\n"), "4: [method.a] class",
                      {"Gain has no adapt()", "a class with adapt(observation)"}));
  EXPECT_TRUE(refuses(section_for("parameters.py", "Tuner"), "4: [method.a] class",
                      {"Tuner has no step()"}));
}

TEST(PythonMethod, TakesParametersAsOptionsThatEachStepReads) {
  const auto method = load(section_for("parameters.py", "Gain"));
  method->reset({});
  method->set_parameter("gain", "0.25");
  method->set_parameter("count", "2");
  method->set_parameter("fast", "true");
  EXPECT_EQ(step(*method), (Values{0.25, 2, 1}));
  const auto taking = load(section_for("parameters.py", "Taking"));
  taking->reset({});
  taking->set_parameter("gain", "0.25");
  EXPECT_EQ(step(*taking), (Values{1.25, 0, 0}));
}

TEST(PythonMethod, RefusesParametersThatItCannotTake) {
  const auto error_of = [](const std::string& name, const std::string& key,
                           const std::string& value) {
    const auto method = load(section_for("parameters.py", name));
    method->reset({});
    try {
      method->set_parameter(key, value);
      return std::string("is taken");
    } catch (const MethodError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_TRUE(mentions(error_of("Gain", "gian", "1"), {"'gian' is not an option", "'gain'"}));
  EXPECT_TRUE(mentions(error_of("Gain", "count", "1.5"), {"count", "'1.5'", "an integer"}));
  EXPECT_TRUE(
      mentions(error_of("Copying", "gain", "2"),
               {"cannot be set during a run", "Copying has no set_parameter(name, value)"}));
}

TEST(PythonMethod, IsRefusedWithoutAModuleThatCanBeImported) {
  EXPECT_TRUE(refuses("[method.a]\nadapter = python\n", "1: [method.a]", {"missing module"}));
  EXPECT_TRUE(refuses(section_for("none.py", "Echo"), "3: [method.a] module",
                      {"'none.py' not found", "/none.py"}));
  EXPECT_TRUE(refuses(section_for("malformed.py", "Echo"), "3: [method.a] module",
                      {"cannot be imported", "SyntaxError"}));
}

TEST(PythonMethod, IsRefusedWithoutAClassThatIsComplete) {
  EXPECT_TRUE(refuses(section_for("echo.py", "Ecko"), "4: [method.a] class",
                      {"no class 'Ecko'", "'Echo'"}));
  EXPECT_TRUE(refuses("[method.a]\nadapter = python\nmodule = echo.py\n", " [method.a] class",
                      {"missing", "a class with step()"}));
  EXPECT_TRUE(
      refuses(section_for("echo.py", "NoStep"), "4: [method.a] class", {"NoStep has no step()"}));
  EXPECT_TRUE(refuses(section_for("echo.py", "BadOptions"), "4: [method.a] class",
                      {"malformed option 'gain'"}));
}

TEST(PythonMethod, IsRefusedForAnOptionThatIsUnknownOrMalformed) {
  EXPECT_TRUE(refuses(section_for("echo.py", "Echo", "gian = 2\n"), "5: [method.a] gian",
                      {"unknown option of the class", "'gain'"}));
  EXPECT_TRUE(refuses(section_for("echo.py", "Echo", "gain = fast\n"), "5: [method.a] gain",
                      {"'fast'", "a number"}));
  EXPECT_TRUE(refuses(section_for("echo.py", "Echo", "count = 2.5\n"), "5: [method.a] count",
                      {"'2.5'", "an integer"}));
  EXPECT_TRUE(refuses(section_for("echo.py", "Echo", "enabled = maybe\n"), "5: [method.a] enabled",
                      {"'maybe'", "true or false"}));
}

TEST(PythonMethod, IsRefusedWithTheExceptionOfItsConstructor) {
  EXPECT_TRUE(refuses(section_for("echo.py", "Echo", "gain = -1\n"), "4: [method.a] class",
                      {"Echo cannot be created: ValueError: negative gain (echo.py:"}));
}

}  // namespace
}  // namespace slalom
