#include "error_text.h"

#include <slalom/library/library_method.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

const std::string kFolder = PLUGIN_FOLDER;

std::string plugin_file(const std::string& name) {
  return kFolder + "/lib" + name + ".so";
}

/// Line 3 names the plug-in, further keys begin at line 4.
std::string section_for(const std::string& plugin, const std::string& keys = "") {
  return "[method.a]\nadapter = library\nplugin = " + plugin + "\n" + keys;
}

std::unique_ptr<Method> load(const std::string& ini_text, const RobotModel& robot = {},
                             const SensorModel& sensor = {}) {
  const IniFile ini = IniFile::from_text(ini_text, "campaign.ini");
  return make_library_method({ini, "method.a", robot, sensor});
}

std::unique_ptr<Method> load_good(const std::string& keys = "") {
  return load(section_for(plugin_file("test_plugin_good"), keys));
}

std::string refusal(const std::string& ini_text) {
  return error_text(Culprit::Usage, [&] { load(ini_text); });
}

std::string refusal_of(const std::string& name) {
  return refusal(section_for(plugin_file(name)));
}

/// "campaign.ini:3: [method.a] plugin: FILE WHAT".
std::string about_plugin(const std::string& name, const std::string& what) {
  return "campaign.ini:3: [method.a] plugin: " + plugin_file(name) + " " + what;
}

mrpt::obs::CObservation2DRangeScan scan_of(const std::vector<float>& ranges) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.resizeScan(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    scan.setScanRange(i, ranges[i]);
    scan.setScanRangeValidity(i, true);
  }
  return scan;
}

Observation observation_of(const mrpt::obs::CObservation2DRangeScan& scan) {
  Observation observation;
  observation.time = 12.5;
  observation.odometry = {1, 2, 0.25};
  observation.v = 0.5;
  observation.w = -0.75;
  observation.goal_in_robot = {3, -4};
  observation.scan = &scan;
  return observation;
}

/// What the good plug-in answers with when it is asked for `answer`.
std::pair<double, double> echo(const std::string& answer) {
  RobotModel robot;
  robot.radius = 0.375;
  robot.max_v = 1.25;
  robot.max_w = 2.5;
  robot.max_accel_v = 0.5;
  robot.max_accel_w = 4.5;
  SensorModel sensor;
  sensor.rays = 3;
  sensor.max_range = 6;
  const auto method = load(
      section_for(plugin_file("test_plugin_good"), "answer = " + answer + "\n"), robot, sensor);
  Task task;
  task.start = {10, 20, 0.5};
  task.goal = {30, 40};
  task.goal_tolerance = 0.25;
  task.control_period = 0.125;
  task.seed = 1ULL << 52;
  method->reset(task);
  const auto scan = scan_of({7.5F, 8, 1.5F});
  const Command command = method->step(observation_of(scan));
  return {command.v, command.w};
}

std::vector<double> commands_of_run(Method& method, int steps) {
  const auto scan = scan_of({1, 2, 3});
  method.reset({});
  std::vector<double> commands;
  for (int i = 0; i < steps; ++i) {
    const Command command = method.step(observation_of(scan));
    commands.insert(commands.end(), {command.v, command.w});
  }
  return commands;
}

TEST(LibraryMethod, PassesEverythingAcrossTheBorder) {
  using Two = std::pair<double, double>;
  EXPECT_EQ(echo("position"), Two(1, 2));
  EXPECT_EQ(echo("heading"), Two(0.25, 12.5));
  EXPECT_EQ(echo("speeds"), Two(0.5, -0.75));
  EXPECT_EQ(echo("goal"), Two(3, -4));
  EXPECT_EQ(echo("rays"), Two(3, 3));
  EXPECT_EQ(echo("ranges"), Two(7.5, 1.5));
  EXPECT_EQ(echo("body"), Two(0.375, 1));
  EXPECT_EQ(echo("limits"), Two(1.25, 2.5));
  EXPECT_EQ(echo("accel"), Two(0.5, 4.5));
  EXPECT_EQ(echo("sensor"), Two(SensorModel{}.aperture(), 6));
  EXPECT_EQ(echo("start"), Two(10, 20));
  EXPECT_EQ(echo("task_goal"), Two(30, 40));
  EXPECT_EQ(echo("task"), Two(0.5, 0.25));
  EXPECT_EQ(echo("seed"), Two(4503599627370496.0, 0.125));
}

TEST(LibraryMethod, GivesTheMethodItsOwnSettings) {
  const auto method = load_good("gain = 2.5\n");
  EXPECT_EQ(commands_of_run(*method, 1), (std::vector<double>{1, 2.5}));
}

TEST(LibraryMethod, AnswersTheSameAgainAfterAReset) {
  const auto method = load_good();
  const std::vector<double> first = commands_of_run(*method, 3);
  EXPECT_EQ(first, (std::vector<double>{1, 1, 2, 1, 3, 1}));
  EXPECT_EQ(commands_of_run(*method, 3), first);
}

TEST(LibraryMethod, TwoOfOneLibraryShareNoState) {
  const auto one = load_good("gain = 5\n");
  const auto other = load_good("gain = 7\n");
  commands_of_run(*one, 2);
  EXPECT_EQ(commands_of_run(*other, 1), (std::vector<double>{1, 7}));
  const auto scan = scan_of({1});
  EXPECT_EQ(one->step(observation_of(scan)).v, 3);
}

TEST(LibraryMethod, RefusesAKeyThatTheMethodDoesNotKnow) {
  EXPECT_EQ(refusal(section_for(plugin_file("test_plugin_good"), "gian = 2\n")),
            "campaign.ini:4: [method.a] gian: good has no such parameter; expected 'gain'");
  EXPECT_EQ(refusal(section_for(plugin_file("test_plugin_good"), "zzzzzzzzzzzz = 2\n")),
            "campaign.ini:4: [method.a] zzzzzzzzzzzz: good has no such parameter; expected one of "
            "answer, gain");
  EXPECT_EQ(refusal(section_for(plugin_file("test_plugin_step_fails"), "speed = 2\n")),
            "campaign.ini:4: [method.a] speed: faulty has no such parameter; expected no key but "
            "adapter and plugin");
}

TEST(LibraryMethod, RefusesASectionWithoutALibrary) {
  EXPECT_EQ(refusal("[method.a]\nadapter = library\n"),
            "campaign.ini:1: [method.a]: no library named; expected plugin = PATH of a shared "
            "library");
}

TEST(LibraryMethod, RefusesAMissingFile) {
  EXPECT_EQ(refusal_of("test_plugin_absent"),
            "campaign.ini:3: [method.a] plugin: no library '" + plugin_file("test_plugin_absent") +
                "'; expected a file at " + plugin_file("test_plugin_absent"));
}

TEST(LibraryMethod, RefusesAFileThatIsNoLibrary) {
  const std::string path = kFolder + "/no_library.so";
  std::ofstream(path) << "This is text.\n";
  const std::string text = refusal(section_for(path));
  EXPECT_EQ(text.rfind("campaign.ini:3: [method.a] plugin: " + path + " cannot be loaded (", 0), 0U)
      << text;
  EXPECT_NE(text.find("; expected a shared library"), std::string::npos) << text;
}

TEST(LibraryMethod, RefusesAFolder) {
  EXPECT_EQ(refusal(section_for(kFolder)), "campaign.ini:3: [method.a] plugin: no library '" +
                                               kFolder + "'; expected a file at " + kFolder);
}

TEST(LibraryMethod, ExplainsASymbolThatVisibilityHides) {
  EXPECT_EQ(refusal_of("test_plugin_hidden"),
            about_plugin("test_plugin_hidden",
                         "does not export slalom_method_get_api(); expected a library with that "
                         "function, marked SLALOM_METHOD_EXPORT so that hidden visibility does not "
                         "hide it"));
}

TEST(LibraryMethod, RefusesAnotherVersionOfThePrototype) {
  EXPECT_EQ(refusal_of("test_plugin_old"),
            about_plugin("test_plugin_old",
                         "is made for version 8 of the method prototype; expected version 1: "
                         "build it again"));
}

TEST(LibraryMethod, RefusesATableThatIsMissingOrHasHoles) {
  EXPECT_EQ(refusal_of("test_plugin_no_table"),
            about_plugin("test_plugin_no_table", "returned no table of functions"));
  EXPECT_EQ(refusal_of("test_plugin_incomplete"),
            about_plugin("test_plugin_incomplete",
                         "leaves entries of its table of functions empty; expected create, reset, "
                         "step, destroy and name"));
}

TEST(LibraryMethod, PassesOnWhyTheMethodRefusesInOneLine) {
  EXPECT_EQ(refusal_of("test_plugin_refuses"),
            "campaign.ini:1: [method.a]: faulty refuses: the robot is too wide");
  EXPECT_EQ(refusal_of("test_plugin_mute"),
            "campaign.ini:1: [method.a]: faulty refuses: no reason given");
}

TEST(LibraryMethod, TurnsErrorCodesIntoMethodErrors) {
  const auto scan = scan_of({1});
  const auto resets = load(section_for(plugin_file("test_plugin_reset_fails")));
  const auto steps = load(section_for(plugin_file("test_plugin_step_fails")));
  steps->reset({});
  try {
    resets->reset({});
    FAIL() << "reset() succeeded";
  } catch (const MethodError& error) {
    EXPECT_STREQ(error.what(), "faulty: reset returned error 4");
  }
  try {
    steps->step(observation_of(scan));
    FAIL() << "step() succeeded";
  } catch (const MethodError& error) {
    EXPECT_STREQ(error.what(), "faulty: step returned error 3");
  }
}

}  // namespace
}  // namespace slalom
