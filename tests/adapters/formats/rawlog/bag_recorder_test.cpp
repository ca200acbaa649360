// SPDX-License-Identifier: BSD-3-Clause
#include "../../../../adapters/formats/bags/src/byte_cursor.h"
#include "recorded_runs.h"

#include <slalom/bags/frame_tree.h>
#include <slalom/bags/ros_encoding.h>
#include <slalom/core/read_file.h>
#include <slalom/rawlog/bag_recorder.h>

#include <cmath>
#include <error_text.h>
#include <map>

namespace slalom {
namespace {

using mrpt::math::TPose2D;

constexpr std::int64_t kBagStart = 1'000'000'002'000'000'000;  // ns, as that of rawlogs

/// The disc of a marker: name, position, diameter, and whether it is removed.
struct MarkedDisc {
  std::string name;
  double x, y, diameter;
  bool removed;
};

/// Reads visualization_msgs/MarkerArray member by member (common_interfaces, Humble to Kilted).
std::vector<MarkedDisc> decode_markers(const BagMessage& message) {
  ByteCursor cursor(message.data.substr(4), message.place, ByteLayout::CdrLittleEndian);
  std::vector<MarkedDisc> discs(cursor.get<std::uint32_t>());
  const auto skip = [&](auto kind, int count) {
    for (int i = 0; i < count; ++i) cursor.get<decltype(kind)>();
  };
  for (MarkedDisc& disc : discs) {
    skip(std::int32_t{}, 2);  // stamp
    EXPECT_EQ(cursor.text(), "map");
    disc.name = cursor.text();
    cursor.get<std::int32_t>();                // id
    EXPECT_EQ(cursor.get<std::int32_t>(), 3);  // a cylinder
    disc.removed = cursor.get<std::int32_t>() == 2;
    disc.x = cursor.get<double>();
    disc.y = cursor.get<double>();
    skip(double{}, 5);  // height, rotation
    disc.diameter = cursor.get<double>();
    skip(double{}, 2);        // scale
    skip(float{}, 4);         // color
    skip(std::int32_t{}, 2);  // lifetime
    cursor.get<std::uint8_t>();
    skip(std::uint32_t{}, 2);  // points, colors
    cursor.text();             // texture
    skip(std::int32_t{}, 2);   // stamp of its image
    cursor.text();
    cursor.text();
    skip(std::uint32_t{}, 2);  // bytes, coordinates
    for (int i = 0; i < 3; ++i) cursor.text();
    cursor.get<std::uint32_t>();
    cursor.get<std::uint8_t>();
  }
  EXPECT_TRUE(cursor.at_end());
  return discs;
}

/// The contents of a recorded bag, by topic and in order.
struct ReadBag {
  std::map<std::string, std::string> types;
  std::map<std::string, std::vector<RosScan>> scans;
  std::map<std::string, std::vector<RosOdometry>> odometry;
  std::vector<RosTransform> map_to_odom, odom_to_base;
  FrameTree frames;
  std::vector<RosTwist> commands;
  std::vector<RosStampedPose> goals;
  std::vector<RosGrid> maps;
  std::vector<std::vector<MarkedDisc>> movers;
  std::vector<std::int64_t> times;
};

void add_message(const BagMessage& message, ReadBag& bag) {
  const std::string& topic = message.topic.name;
  bag.times.push_back(message.time);
  if (topic.rfind("/scan", 0) == 0) bag.scans[topic].push_back(decode_scan(message));
  if (topic == "/odom" || topic == "/ground_truth")
    bag.odometry[topic].push_back(decode_odometry(message));
  if (topic == "/cmd_vel") bag.commands.push_back(decode_twist(message));
  if (topic == "/goal_pose") bag.goals.push_back(decode_pose(message));
  if (topic == "/map") bag.maps.push_back(decode_grid(message));
  if (topic == "/movers") bag.movers.push_back(decode_markers(message));
  if (topic == "/tf" || topic == "/tf_static")
    for (const RosTransform& one : decode_transforms(message)) {
      bag.frames.add(one);
      if (one.child_frame == "odom") bag.map_to_odom.push_back(one);
      if (one.child_frame == "base_link") bag.odom_to_base.push_back(one);
    }
}

class BagRecorder : public testing::RecordedRunTest {
 protected:
  testing::SimulatedRun record(Method& method, const RunSetup& setup,
                               const Scenario& scenario = testing::some_discs(),
                               const std::string& name = "run.mcap") {
    const World world(scenario, setup.simulation.resolution);
    const auto recorder =
        make_bag_recorder(path(name), make_run_manifest("", scenario, "m", 2, 7), scenario, setup);
    testing::CapturingObserver observer(*recorder);
    testing::SimulatedRun run;
    run.result = simulate(world, setup, 7, method, &observer);
    run.task = observer.task_;
    run.cycles = observer.cycles_;
    return run;
  }

  ReadBag read() const {
    ReadBag bag;
    for (const BagTopic& topic :
         read_bag(path("run.mcap"), [&](const BagMessage& message) { add_message(message, bag); }))
      bag.types[topic.name] = topic.type;
    EXPECT_TRUE(std::is_sorted(bag.times.begin(), bag.times.end()));
    return bag;
  }
};

void expect_pose(const RosPose& read, const TPose2D& pose) {
  EXPECT_EQ(read.x, pose.x);
  EXPECT_EQ(read.y, pose.y);
  EXPECT_NEAR(std::remainder(read.yaw() - pose.phi, 2 * M_PI), 0, 1e-15);
}

void expect_twist(const RosTwist& read, double v, double w, double vy) {
  EXPECT_EQ(read.vx, v);
  EXPECT_EQ(read.wz, w);
  EXPECT_EQ(read.vy, vy);
}

void expect_stamp(std::int64_t read, double time) {
  EXPECT_NEAR(double(read - kBagStart), time * 1e9, 51);  // ticks of 100 ns
}

TEST_F(BagRecorder, GivesBackAllNumbersOfARun) {
  RunSetup setup = testing::noisy_setup();
  setup.robot.kinematics = Kinematics::Holonomic;
  setup.robot.forward_only = false;
  testing::FunctionMethod method([](const Observation& o) {
    return Command{0.3 * std::sin(o.time), -0.5, -0.4 * std::cos(3 * o.time)};
  });
  const auto run = record(method, setup);
  const auto& samples = run.result.trajectory.samples;
  const ReadBag bag = read();
  const auto& odometry = bag.odometry.at("/odom");
  const auto& truth = bag.odometry.at("/ground_truth");
  const auto& scans = bag.scans.at("/scan");
  ASSERT_GT(run.cycles.size(), 20U);
  ASSERT_EQ(odometry.size(), run.cycles.size());
  ASSERT_EQ(scans.size(), run.cycles.size());
  ASSERT_EQ(bag.commands.size(), run.cycles.size());
  ASSERT_EQ(truth.size(), run.cycles.size() + 1) << "also where it ends";
  for (std::size_t i = 0; i < run.cycles.size(); ++i) {
    const Observation& observed = run.cycles[i].observation;
    expect_stamp(odometry[i].header.stamp, observed.time);
    expect_pose(odometry[i].pose, observed.odometry);
    expect_twist(odometry[i].twist, observed.v, observed.w, observed.vy);
    const Command& command = run.cycles[i].command;
    expect_twist(bag.commands[i], command.v, command.w, command.vy);
    expect_stamp(bag.commands[i].header->stamp, observed.time);
    expect_stamp(scans[i].header.stamp, std::max(0.0, observed.time - setup.sensor.latency));
    ASSERT_EQ(scans[i].ranges.size(), run.cycles[i].ranges.size());
    for (std::size_t ray = 0; ray < scans[i].ranges.size(); ++ray)
      if (std::isfinite(scans[i].ranges[ray]))
        ASSERT_EQ(scans[i].ranges[ray], run.cycles[i].ranges[ray]);
      else
        ASSERT_EQ(run.cycles[i].ranges[ray], 8.0F) << "the maximum range";
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    expect_stamp(truth[i].header.stamp, samples[i].t);
    expect_pose(truth[i].pose, samples[i].pose);
    expect_twist(truth[i].twist, samples[i].v, samples[i].w, samples[i].vy);
  }
}

TEST_F(BagRecorder, TheTransformsLeadToTheTruePose) {
  testing::RandomMethod method{RobotModel()};
  RunSetup setup = testing::noisy_setup();
  const auto run = record(method, setup);
  const ReadBag bag = read();
  ASSERT_EQ(bag.map_to_odom.size(), run.cycles.size());
  double drift = 0;
  for (std::size_t i = 0; i < run.cycles.size(); ++i) {
    const auto pose = pose_of(bag.map_to_odom[i].pose) + pose_of(bag.odom_to_base[i].pose);
    const TPose2D& truth = run.result.trajectory.samples[i].pose;
    EXPECT_NEAR(pose.x(), truth.x, 1e-12);
    EXPECT_NEAR(pose.y(), truth.y, 1e-12);
    EXPECT_NEAR(std::remainder(pose.yaw() - truth.phi, 2 * M_PI), 0, 1e-12);
    drift = std::max(drift, std::hypot(truth.x - run.cycles[i].observation.odometry.x,
                                       truth.y - run.cycles[i].observation.odometry.y));
  }
  EXPECT_GT(drift, 1e-3);
  setup.odometry = {};
  record(method, setup);
  for (const RosTransform& one : read().map_to_odom)
    EXPECT_TRUE(one.pose.x == 0 && one.pose.y == 0 && one.pose.qz == 0) << "without drift";
}

TEST_F(BagRecorder, EachOfSeveralLasersHasATopicAndAFrame) {
  RunSetup setup;
  setup.sensor.lasers.resize(2);
  setup.sensor.lasers[0] = {"left", 0.1, 0.2, 0.5};
  setup.sensor.lasers[0].rays = 31;
  setup.sensor.lasers[1] = {"rear", -0.3, 0, 3, true};
  auto method = testing::constant_method(0.4, 0.1);
  const auto run = record(method, setup);
  const ReadBag bag = read();
  ASSERT_EQ(bag.scans.size(), 2U);
  EXPECT_EQ(bag.scans.at("/scan_left").size(), run.cycles.size());
  EXPECT_EQ(bag.scans.at("/scan_left")[3].ranges.size(), 31U);
  EXPECT_EQ(bag.scans.at("/scan_left")[3].header.frame, "laser_left");
  const auto& frames = bag.frames.frames();
  EXPECT_EQ(frames.at("laser_left").parent, "base_link");
  expect_pose(frames.at("laser_left").pose, {0.1, 0.2, 0.5});
  const auto rear = pose_of(frames.at("laser_rear").pose);
  EXPECT_NEAR(rear.x(), -0.3, 1e-12);
  EXPECT_NEAR(rear.yaw(), 3, 1e-12);
  EXPECT_NEAR(std::abs(rear.roll()), M_PI, 1e-12);
}

TEST_F(BagRecorder, TheOnlyLaserHasTheUsualNames) {
  RunSetup setup;
  setup.sensor.lasers = {{"front", 0.1, 0, 0}};
  setup.sensor.lasers[0].range_min = 0.25;
  setup.sensor.lasers[0].aperture_deg = 90;
  auto method = testing::constant_method(0.4, 0.1);
  record(method, setup);
  const RosScan scan = read().scans.at("/scan").at(0);
  EXPECT_EQ(scan.header.frame, "laser");
  EXPECT_EQ(scan.range_min, 0.25);
  EXPECT_EQ(scan.range_max, 8);
  EXPECT_NEAR(scan.angle_min, -M_PI / 4, 1e-7);
  EXPECT_NEAR(scan.angle_increment, M_PI / 2 / 180, 1e-9);
}

TEST_F(BagRecorder, TheMapAndTheGoalAreThoseOfTheScenario) {
  auto method = testing::constant_method(0.4, 0.1);
  record(method, {});
  const ReadBag bag = read();
  ASSERT_EQ(bag.maps.size(), 1U);
  const RosGrid& map = bag.maps[0];
  EXPECT_EQ(map.header.frame, "map");
  EXPECT_EQ(map.width, 200U);  // 10 m of cells of 0.05 m
  EXPECT_FLOAT_EQ(float(map.resolution), 0.05F);
  const auto cell = [&](double x, double y) {
    return map.cells.at(std::size_t(y / 0.05) * map.width + std::size_t(x / 0.05));
  };
  EXPECT_EQ(cell(4, 5.2), 100);  // in a disc
  EXPECT_EQ(cell(2.5, 8), 100);
  EXPECT_EQ(cell(8, 2.5), 0);
  EXPECT_EQ(std::size_t(std::count(map.cells.begin(), map.cells.end(), 100)),
            World(testing::some_discs(), 0.05).occupancy().count_occupied());
  ASSERT_EQ(bag.goals.size(), 1U);
  expect_pose(bag.goals[0].pose, {9, 5, 0});  // straight ahead of (1, 5)
  EXPECT_EQ(bag.types.count("/movers"), 0U);
}

TEST_F(BagRecorder, MovingObstaclesAreDiscsWhereTheyAre) {
  const Movers movers = {{"a", 0.3, {{0, {5, 1}}, {2, {7, 1}}}, MoverEnd::Stop},
                         {"b", 0.2, {{0.5, {5, 9}}, {1, {5, 8}}}, MoverEnd::Vanish}};
  RunSetup setup;
  setup.simulation.max_time = 2;
  auto method = testing::constant_method(0, 0);
  const auto run = record(method, setup, testing::some_discs().with_movers(movers));
  const ReadBag bag = read();
  const auto& samples = run.result.trajectory.samples;
  ASSERT_EQ(bag.movers.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(bag.movers[i].size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
      const MarkedDisc& disc = bag.movers[i][k];
      EXPECT_EQ(disc.name, movers[k].id);
      EXPECT_EQ(disc.x, movers[k].position(samples[i].t).x);
      EXPECT_EQ(disc.y, movers[k].position(samples[i].t).y);
      EXPECT_EQ(disc.diameter, 2 * movers[k].radius);
      EXPECT_EQ(disc.removed, !movers[k].present(samples[i].t));
    }
  }
}

TEST_F(BagRecorder, TheSameRunGivesTheSameBytesRegardlessOfPreviousRuns) {
  auto method = testing::constant_method(0.4, 0.1);
  record(method, {}, testing::some_discs(), "a.mcap");
  record(method, testing::noisy_setup(), testing::some_discs(), "other.mcap");
  record(method, {}, testing::some_discs(), "b.mcap");
  EXPECT_EQ(read_file(path("a.mcap")), read_file(path("b.mcap")));
  EXPECT_NE(read_file(path("a.mcap")), read_file(path("other.mcap")));
}

TEST_F(BagRecorder, ARunThatCannotStartHasNoTopics) {
  auto method = testing::constant_method(0.4, 0);
  const auto run = record(method, {}, testing::some_discs().with_start_goal({4, 5, 0}, {9, 5}));
  ASSERT_EQ(run.result.outcome, Outcome::UnsolvableScenario);
  EXPECT_TRUE(read().types.empty());
  EXPECT_NE(read_file(path("run.mcap")).find("unsolvable_scenario"), std::string::npos);
}

TEST_F(BagRecorder, ReportsWriteErrors) {
  auto method = testing::constant_method(0.4, 0);
  EXPECT_TRUE(throws_error(ErrorKind::Job, "", {"no/such/run.mcap"},
                           [&] { record(method, {}, testing::some_discs(), "no/such/run.mcap"); }));
}

}  // namespace
}  // namespace slalom
