// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "places.h"

#include <slalom/library/library_method.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

const std::string kFolder = kBuild + "/tests/adapters/methods/library/plugins";

std::string plugin_file(const std::string& name) {
  return kFolder + "/lib" + name + ".so";
}

/// Line 3 contains the plug-in, further keys start at line 4.
std::string section_for(const std::string& plugin, const std::string& keys = "") {
  return "[method.a]\nadapter = library\nplugin = " + plugin + "\n" + keys;
}

std::unique_ptr<Method> load(const std::string& ini_text, const RobotModel& robot = {},
                             const SensorModel& sensor = {}) {
  const IniFile ini = IniFile::from_text(ini_text, "campaign.ini");
  return read_library_method(ini, "method.a")(robot, sensor);
}

std::unique_ptr<Method> load_good(const std::string& keys = "") {
  return load(section_for(plugin_file("test_plugin_good"), keys));
}

testing::AssertionResult refuses(const std::string& ini_text, const std::string& where,
                                 std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, "campaign.ini:" + where, words, [&] { load(ini_text); });
}

/// Loading the plug-in fails with an error about the key `plugin`.
testing::AssertionResult refuses_plugin(const std::string& name,
                                        std::initializer_list<std::string> words) {
  const std::string file = plugin_file(name);
  return refuses(section_for(file), "3: [method.a] plugin: " + file + " ", words);
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

/// The command of the good plug-in for the key `answer`.
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
  NavigationTask task;
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

TEST(LibraryMethod, PassesAllFieldsThroughTheCInterface) {
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

TEST(LibraryMethod, IsGivenTracksIfItDeclaresThem) {
  EXPECT_FALSE(load_good()->uses_tracks());
  const auto scan = scan_of({1});
  const std::vector<Track> two = {{3, {1, -2}, {0.5, 0.25}, 0.3}, {7, {4, 4}, {0, 0}, 0.2}};
  Observation observation = observation_of(scan);
  const auto echo_of = [&](const std::string& answer, const std::vector<Track>& tracks) {
    const auto method =
        load(section_for(plugin_file("test_plugin_tracks"), "answer = " + answer + "\n"));
    EXPECT_TRUE(method->uses_tracks());
    method->reset({});
    observation.tracks = &tracks;
    const Command command = method->step(observation);
    return std::pair(command.v, command.w);
  };
  EXPECT_EQ(echo_of("tracks", two), std::pair(2.0, 3.0));
  EXPECT_EQ(echo_of("track_position", two), std::pair(1.0, -2.0));
  EXPECT_EQ(echo_of("track_velocity", two), std::pair(0.5, 0.25));
  EXPECT_EQ(echo_of("track_radius", two), std::pair(0.3, 0.0));
  EXPECT_EQ(echo_of("tracks", {}).first, 0);
  const std::vector<Track> three(3);
  EXPECT_THROW(echo_of("tracks", three), MethodError) << "set_tracks() returns an error code";
}

TEST(LibraryMethod, ThatUsesTracksRefusesInputsWithoutAndOtherVersions) {
  const auto scan = scan_of({1});
  const auto method = load(section_for(plugin_file("test_plugin_tracks")));
  method->reset({});
  try {
    method->step(observation_of(scan));
    FAIL() << "step() succeeded";
  } catch (const MethodError& error) {
    EXPECT_STREQ(error.what(),
                 "the method needs the tracks of movers, which this input does not contain");
  }
  EXPECT_TRUE(refuses_plugin("test_plugin_tracks_version",
                             {"slalom_method_get_tracks_api()", "expected version 1"}));
}

TEST(LibraryMethod, IsGivenTheMapIfItDeclaresIt) {
  EXPECT_FALSE(load_good()->uses_map());
  EXPECT_FALSE(load(section_for(plugin_file("test_plugin_map")))->uses_map()) << "answer = steps";
  const auto scan = scan_of({1});
  const std::vector<std::uint8_t> cells = {0, 0, 0, 0, 0, 1};
  KnownMap map = {0.5, {-1, 2}, 3, 2, &cells};
  const auto echo_of = [&](const std::string& answer) {
    const auto method =
        load(section_for(plugin_file("test_plugin_map"), "answer = " + answer + "\n"));
    EXPECT_TRUE(method->uses_map());
    NavigationTask task;
    EXPECT_THROW(method->reset(task), MethodError) << "a task without a map";
    task.map = &map;
    method->reset(task);
    const Command command = method->step(observation_of(scan));
    return std::pair(command.v, command.w);
  };
  EXPECT_EQ(echo_of("map_origin"), std::pair(-1.0, 2.0));
  EXPECT_EQ(echo_of("map_size"), std::pair(3.0, 2.0));
  EXPECT_EQ(echo_of("map_cells"), std::pair(0.5, 1.0));
  map.size_x = 6;
  map.size_y = 1;
  EXPECT_THROW(echo_of("map_size"), MethodError) << "set_map() returns an error code";
  EXPECT_TRUE(
      refuses_plugin("test_plugin_map_incomplete",
                     {"slalom_method_get_map_api()", "version 1 with uses_map and set_map"}));
}

TEST(LibraryMethod, PassesTheParametersToTheMethod) {
  const auto method = load_good("gain = 2.5\n");
  EXPECT_EQ(commands_of_run(*method, 1), (std::vector<double>{1, 2.5}));
}

TEST(LibraryMethod, GivesTheSameCommandsAfterAReset) {
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

TEST(LibraryMethod, RefusesUnknownParameters) {
  const std::string good = plugin_file("test_plugin_good");
  EXPECT_TRUE(refuses(section_for(good, "gian = 2\n"),
                      "4: [method.a] gian: ", {"unknown parameter", "good", "expected 'gain'"}));
  EXPECT_TRUE(refuses(section_for(good, "zzzzzzzzzzzz = 2\n"), "4: [method.a] zzzzzzzzzzzz: ",
                      {"unknown parameter", "good", "expected one of answer, gain"}));
  EXPECT_TRUE(refuses(section_for(plugin_file("test_plugin_step_fails"), "speed = 2\n"),
                      "4: [method.a] speed: ",
                      {"unknown parameter", "faulty", "expected no key", "adapter", "plugin"}));
}

TEST(LibraryMethod, IsMadeFromOptionsOfAProgram) {
  const std::string good = plugin_file("test_plugin_good");
  EXPECT_NE(plugin(good)({}, {}), nullptr);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "plugin.speed_limit: ", {"unknown parameter"}, [&] {
    plugin(good, {{"speed_limit", "1"}})({}, {});
  }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "plugin.plugin: ", {"'libabsent.so' not found"},
                           [] { plugin("libabsent.so")({}, {}); }));
}

TEST(LibraryMethod, RefusesASectionWithoutALibrary) {
  EXPECT_TRUE(refuses("[method.a]\nadapter = library\n",
                      "1: [method.a]: ", {"library", "expected plugin = PATH"}));
}

TEST(LibraryMethod, RefusesAMissingFile) {
  const std::string file = plugin_file("test_plugin_absent");
  EXPECT_TRUE(refuses(section_for(file), "3: [method.a] plugin: ",
                      {"'" + file + "' not found", "expected a file at " + file}));
}

TEST(LibraryMethod, RefusesAFileThatIsNotALibrary) {
  const std::string path = kFolder + "/no_library.so";
  std::ofstream(path) << "This is text.\n";
  EXPECT_TRUE(refuses(section_for(path), "3: [method.a] plugin: " + path + " ",
                      {"cannot be loaded (", "expected a shared library"}));
}

TEST(LibraryMethod, RefusesAFolder) {
  EXPECT_TRUE(refuses(section_for(kFolder), "3: [method.a] plugin: ",
                      {kFolder + ": cannot be read (is a folder)", "expected a file"}));
}

TEST(LibraryMethod, ExplainsAHiddenSymbol) {
  EXPECT_TRUE(refuses_plugin("test_plugin_hidden", {"does not export slalom_method_get_api()",
                                                    "SLALOM_METHOD_EXPORT", "hidden visibility"}));
}

TEST(LibraryMethod, RefusesAnotherVersionOfThePrototype) {
  EXPECT_TRUE(
      refuses_plugin("test_plugin_old", {"version 8", "method prototype", "expected version 1"}));
}

TEST(LibraryMethod, RefusesAMissingOrIncompleteFunctionTable) {
  EXPECT_TRUE(refuses_plugin("test_plugin_no_table", {"function table"}));
  EXPECT_TRUE(refuses_plugin("test_plugin_incomplete",
                             {"function table", "expected create, reset, step, destroy and name"}));
}

TEST(LibraryMethod, ReportsWhyTheMethodCannotBeCreatedInOneLine) {
  EXPECT_TRUE(refuses(section_for(plugin_file("test_plugin_refuses")), "1: [method.a]: faulty ",
                      {": the robot is too wide"}));
  EXPECT_TRUE(refuses(section_for(plugin_file("test_plugin_no_reason")), "1: [method.a]: faulty ",
                      {"no reason given"}));
}

TEST(LibraryMethod, ConvertsErrorCodesToMethodErrors) {
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
