// SPDX-License-Identifier: BSD-3-Clause
#include "message_bytes.h"

#include <slalom/bags/bag_info.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <temporary_folder.h>

namespace slalom {
namespace {

using testing::kSecond;
using testing::Layout;

constexpr std::int64_t kRecorded = 1'700'000'000 * kSecond;  // 2023-11-14 22:13:20 UTC

class BagInfoTest : public ::testing::Test {
 protected:
  BagInfoTest() {
    for (int i = 0; i < 5; ++i)
      add("/scan", "sensor_msgs/LaserScan", i * kSecond,
          testing::scan_bytes(Layout::CdrLittle, i * kSecond, "laser", 0, 1, 5, {1, 2}));
    add("/tf", "tf2_msgs/TFMessage", 0,
        testing::transform_bytes(Layout::CdrLittle, 0, "base_link", "laser",
                                 testing::pose_numbers(0.25, 0, M_PI / 2)));
    writer_.add_channel("/a\x1b[2J", "a/b");
    testing::write_bytes(folder_ / "a.mcap", writer_.bytes());
  }
  void add(const std::string& topic, const std::string& type, std::int64_t time,
           const std::string& data) {
    writer_.add({topic, type, kRecorded + time, data});
  }

  TemporaryFolder folder_;
  testing::McapWriter writer_;
};

TEST_F(BagInfoTest, ListsTopicsAndFrames) {
  const BagInfo info = read_bag_info(folder_ / "a.mcap");
  EXPECT_EQ(info.messages, 6U);
  EXPECT_EQ(info.duration(), 4);
  ASSERT_EQ(info.topics.size(), 3U);
  EXPECT_EQ(info.topics[0].messages, 0U);
  EXPECT_EQ(info.topics[1].frames, std::vector<std::string>{"laser"});
  EXPECT_EQ(info.last_stamp.value(), 4 * kSecond);
  EXPECT_EQ(info.frames.frames().at("laser").parent, "base_link");
}

TEST_F(BagInfoTest, IsShownInLines) {
  EXPECT_EQ(render_text(read_bag_info(folder_ / "a.mcap")),
            folder_ / "a.mcap" +
                ": MCAP, 6 messages in 4.0 s from 2023-11-14 22:13:20 UTC\n"
                "stamps are of another clock (simulation?): 0.0 to 4.0 s\n"
                "topic      type                   messages  rate    frame\n"
                "/a\\x1b[2J  a/b                    0         -       -\n"
                "/scan      sensor_msgs/LaserScan  5         1.0 Hz  laser\n"
                "/tf        tf2_msgs/TFMessage     1         -       -\n"
                "frame  in         pose\n"
                "laser  base_link  (0.25, 0, 0) m, yaw 1.571\n");
}

TEST_F(BagInfoTest, IsWrittenAsJson) {
  const auto json = nlohmann::json::parse(render_json(read_bag_info(folder_ / "a.mcap")));
  EXPECT_EQ(json["format"], "MCAP");
  EXPECT_EQ(json["topics"][1]["messages"], 5);
  EXPECT_EQ(json["first"], kRecorded);
  EXPECT_EQ(json["frames"][0]["pose"][0], 0.25);
}

TEST_F(BagInfoTest, ABagWithoutMessagesHasNoDuration) {
  testing::write_bytes(folder_ / "b.mcap", testing::McapWriter().bytes());
  const BagInfo info = read_bag_info(folder_ / "b.mcap");
  EXPECT_EQ(info.duration(), 0);
  EXPECT_EQ(render_text(info), folder_ / "b.mcap" +
                                   ": MCAP, 0 messages\n"
                                   "topic  type  messages  rate  frame\n");
}

}  // namespace
}  // namespace slalom
